import { FurrowError } from 'furrow'
import { MAX_BLOOD_AMPLITUDE, MAX_LAYERS, MAX_NUMBER, resampleHeights } from 'furrow/internal'
import {
  type ImageFile,
  LAYER_DEFAULTS,
  type MapName,
  type StudioDocument,
  type StudioLayer,
} from './document.ts'
import { changed, checkCount, checkNewName, findNamed, kept, replaceNamed } from './names.ts'
import { checkRange } from './ranges.ts'
import { heightMapOf, type Sculpted, sculptedOf, sculptedSize } from './sculpted.ts'

/** Fields of a layer that `setLayer` can change. */
export type LayerFields = Partial<
  Pick<
    StudioLayer,
    'kind' | 'normalScale' | 'occlusionStrength' | 'heightAmplitude' | 'bloodAmplitude' | 'onsetStrength'
  >
>

/** Adds a layer without maps. Throws FurrowError if the name is taken or there are already 4 layers. */
export function addLayer(document: StudioDocument, name: string): StudioDocument {
  checkNewName(document.layers, name, 'layer')
  checkCount(document.layers, MAX_LAYERS, 'layer')
  return { ...document, layers: [...document.layers, { ...LAYER_DEFAULTS, name }] }
}

/** Removes a layer with its strokes and furrows. Throws FurrowError if areas still use it. */
export function removeLayer(document: StudioDocument, name: string): StudioDocument {
  findNamed(document.layers, name, 'layer')
  const shown = document.areas.filter(({ layer }) => layer === name)
  if (shown.length > 0 || document.layers.length === 1) {
    throw new FurrowError({
      who: 'Studio',
      problem: shown.length > 0 ? `areas show the layer ${name}` : `${name} is the only layer`,
      value: shown.map((area) => area.name).join(', ') || undefined,
      remedy: shown.length > 0 ? 'move them to another layer first' : 'add another one first',
    })
  }
  const { furrows, ...others } = document
  return {
    ...others,
    ...(furrows && furrows.layer !== name && { furrows }),
    layers: document.layers.filter((layer) => layer.name !== name),
    strokes: kept(document.strokes, ({ layer }) => layer !== name),
  }
}

/** Renames a layer, also in areas, strokes and furrows. */
export function renameLayer(document: StudioDocument, name: string, newName: string): StudioDocument {
  if (newName === name) return document
  checkNewName(document.layers, newName, 'layer')
  const rename = <T extends { layer: string }>(item: T): T =>
    item.layer === name ? { ...item, layer: newName } : item
  return {
    ...document,
    layers: replaceNamed(document.layers, name, 'layer', (layer) => ({ ...layer, name: newName })),
    areas: changed(document.areas, rename),
    strokes: changed(document.strokes, rename),
    ...(document.furrows?.layer === name && { furrows: { ...document.furrows, layer: newName } }),
  }
}

/** Moves a layer to another index. Layers do not cover each other, so their order matters only in files and lists. */
export function moveLayer(document: StudioDocument, name: string, index: number): StudioDocument {
  const layer = findNamed(document.layers, name, 'layer')
  const others = document.layers.filter((each) => each !== layer)
  return { ...document, layers: [...others.slice(0, index), layer, ...others.slice(index)] }
}

/** @throws FurrowError if the layer is unknown or a number is outside the range that files allow. */
export function setLayer(document: StudioDocument, name: string, fields: LayerFields): StudioDocument {
  checkRange(`normal scale of ${name}`, fields.normalScale, -MAX_NUMBER, MAX_NUMBER)
  checkRange(`strength of the occlusion of ${name}`, fields.occlusionStrength, 0, 1)
  checkRange(`amplitude of the heights of ${name}`, fields.heightAmplitude, 0, MAX_NUMBER)
  checkRange(`amplitude of the blood of ${name}`, fields.bloodAmplitude, 0, MAX_BLOOD_AMPLITUDE)
  checkRange(`strength of the onset of ${name}`, fields.onsetStrength, 0, 1)
  return {
    ...document,
    layers: replaceNamed(document.layers, name, 'layer', (layer) => ({ ...layer, ...fields })),
  }
}

export function setMap(
  document: StudioDocument,
  name: string,
  map: MapName,
  image: ImageFile | undefined,
): StudioDocument {
  const change = (layer: StudioLayer): StudioLayer => {
    const { isBloodAutomatic, isOnsetDrawn, ...others } = layer
    const maps = { ...layer.maps, [map]: image }
    if (!image) delete maps[map]
    return {
      ...others,
      maps,
      ...(isBloodAutomatic && map !== 'blood' && { isBloodAutomatic }),
      ...(isOnsetDrawn && map !== 'onset' && { isOnsetDrawn }),
    }
  }
  return { ...document, layers: replaceNamed(document.layers, name, 'layer', change) }
}

/** Returns the sculpted heights of a layer at the size that fits its maps. They have no tiles if nothing is sculpted, or without the layer. */
export function sculptedOn({ layers, mapSize }: StudioDocument, name: string): Sculpted {
  const size = sculptedSize(mapSize)
  const sculpted = layers.find((layer) => layer.name === name)?.sculpted ?? { size, tiles: new Map() }
  return sculpted.size === size ? sculpted : sculptedOf(resampleHeights(heightMapOf(sculpted), size, size))
}

/** Sets the sculpted heights of a layer. Removes them if there are no tiles. */
export function setSculpted(
  document: StudioDocument,
  name: string,
  sculpted: Sculpted | null,
): StudioDocument {
  return {
    ...document,
    layers: replaceNamed(document.layers, name, 'layer', ({ sculpted: _, ...layer }) => ({
      ...layer,
      ...(sculpted && sculpted.tiles.size > 0 && { sculpted }),
    })),
  }
}
