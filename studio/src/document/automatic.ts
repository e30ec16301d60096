import { FurrowError } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'
import { autoDrivers, MAX_LAYERS, strokesOf } from 'furrow/internal'
import {
  type AutoSettings,
  type ImageFile,
  LAYER_DEFAULTS,
  type LayerStroke,
  type StudioArea,
  type StudioDocument,
  type StudioLayer,
} from './document.ts'
import { areaOf } from './drivers.ts'
import { shapesOf } from './stroke-areas.ts'

/** Layer names that `autoWrinkles` assigns. */
const AUTOMATIC_LAYER = /^auto\d$/

/**
 * Makes a document of automatic wrinkles: lines as strokes, areas, blood, drivers and expressions.
 *
 * @param names names of the mesh and the material.
 * @param bloodMaps one encoded map per layer; omitted for previews, which never draw from the document.
 */
export function automaticDocument(
  wrinkles: AutoWrinkles,
  auto: AutoSettings,
  areaSize: number,
  names: Pick<StudioDocument, 'mesh' | 'material'>,
  bloodMaps: readonly ImageFile[] = [],
): StudioDocument {
  const { layers, areas, blood, scale } = wrinkles
  const isAutomatic = true
  return {
    ...names,
    scale,
    mapSize: auto.size,
    areaSize,
    layers: layers.map(
      ({ name }, i): StudioLayer => ({
        ...LAYER_DEFAULTS,
        name,
        bloodAmplitude: blood.amplitude,
        ...(bloodMaps[i] && { maps: { blood: bloodMaps[i] }, isBloodAutomatic: true }),
      }),
    ),
    areas: [...areas, ...blood.areas].map(({ name, layer, weights }): StudioArea => {
      return { name, layer: layers[layer].name, combine: 'sum', activation: 0, weights, isAutomatic }
    }),
    strokes: (strokesOf(wrinkles).strokes as LayerStroke[]).map((stroke) => ({ ...stroke, isAutomatic })),
    drivers: autoDrivers(wrinkles),
    auto,
  }
}

/**
 * Replaces the automatic wrinkles of a document and keeps an artist's work. Kept are painted areas with the strokes of their group, bent
 * strokes, layers with images such as blood maps, and the drivers of kept areas.
 */
export function remake(document: StudioDocument, made: StudioDocument): StudioDocument {
  const keptAreas = document.areas.filter((area) => !area.isAutomatic)
  const keptNames = new Set(keptAreas.map(({ name }) => name))
  const keptStrokes = document.strokes.filter(
    ({ isAutomatic, group }) => !isAutomatic || (group !== undefined && keptNames.has(group)),
  )
  // If one line of a group was bent, the group keeps its other lines too.
  const keptGroups = new Set(keptStrokes.map(({ group }) => group))
  const stays = ({ group }: LayerStroke) => keptGroups.has(group)
  const strokes = [
    ...document.strokes.filter(stays),
    ...made.strokes.filter((stroke) => !stays(stroke) && !keptNames.has(stroke.group ?? '')),
  ]
  const areas = [...keptAreas, ...made.areas.filter(({ name }) => !keptNames.has(name))]
  // Images keep their size, and strokes are drawn over them.
  const hasImages = document.layers.some(hasOwnMaps)
  return {
    ...made,
    ...(hasImages && { mapSize: document.mapSize }),
    areaSize: document.areaSize,
    ...(document.furrows && { furrows: document.furrows }),
    ...(document.shapes && { shapes: document.shapes }),
    ...shapesOf(document, keptNames),
    areas: restoreLayers(areas, document, strokes),
    strokes,
    layers: joinedLayers(document, made, areas, strokes),
    drivers: [
      ...document.drivers.filter((driver) => {
        const area = areaOf(driver)
        return area === undefined ? driver.type !== 'expression' : keptNames.has(area)
      }),
      ...made.drivers.filter((driver) => !keptNames.has(areaOf(driver) ?? '')),
    ],
  }
}

/** Returns the number of layers available to automatic wrinkles, beside an artist's own. Throws FurrowError if there is none. */
export function maxAutoLayers(document: StudioDocument | null): number {
  const own = (document?.layers ?? []).filter(({ name }) => !AUTOMATIC_LAYER.test(name)).length
  if (own < MAX_LAYERS) return MAX_LAYERS - own
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: 'no layer is left for automatic wrinkles',
    value: own,
    limit: `${MAX_LAYERS} layers, at least one of them automatic`,
    remedy: 'remove one first',
  })
}

/** Moves automatic areas to the layer of their kept lines. */
function restoreLayers(
  areas: readonly StudioArea[],
  document: StudioDocument,
  strokes: readonly LayerStroke[],
): StudioArea[] {
  const staying = new Set<LayerStroke>(document.strokes)
  return areas.map((area) => {
    const line = strokes.find((stroke) => staying.has(stroke) && isInGroupOf(stroke, area.name))
    return line && area.isAutomatic ? { ...area, layer: line.layer } : area
  })
}

/** Left and right areas can share one group without a side. */
function isInGroupOf({ group }: LayerStroke, area: string): boolean {
  return group === area || group === area.replace(/(Left|Right)$/, '')
}

/** Whether a layer has maps other than automatic blood. */
function hasOwnMaps({ maps, isBloodAutomatic }: StudioLayer): boolean {
  return Object.keys(maps).some((map) => map !== 'blood' || !isBloodAutomatic)
}

/** Merges the used layers of both documents. Existing layers change only in their automatic blood. */
function joinedLayers(
  document: StudioDocument,
  made: StudioDocument,
  areas: readonly StudioArea[],
  strokes: readonly LayerStroke[],
): StudioLayer[] {
  const used = new Set([...areas, ...strokes].map(({ layer }) => layer))
  const hasSameStrength = document.auto?.strength === made.auto?.strength
  const old = document.layers
    .filter((layer) => used.has(layer.name) || hasOwnMaps(layer))
    .map((layer) => {
      const other = made.layers.find(({ name }) => name === layer.name)
      return other ? copyBlood(other, layer, hasSameStrength) : layer
    })
  const names = new Set(old.map(({ name }) => name))
  return [...old, ...made.layers.filter(({ name }) => !names.has(name) && used.has(name))].slice(
    0,
    MAX_LAYERS,
  )
}

/** Copies blood to a layer that has no blood map of its own. @param hasSameStrength keeps the layer's amplitude. */
function copyBlood(
  { maps: { blood }, bloodAmplitude }: StudioLayer,
  layer: StudioLayer,
  hasSameStrength: boolean,
): StudioLayer {
  if (!blood || (layer.maps.blood && !layer.isBloodAutomatic)) return layer
  return {
    ...layer,
    maps: { ...layer.maps, blood },
    bloodAmplitude: (hasSameStrength ? layer.bloodAmplitude : undefined) ?? bloodAmplitude!,
    isBloodAutomatic: true,
  }
}
