import { FurrowError, type GrayImage } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'
import { autoDrivers, DEFAULT_AREA_SIZE, halfSide, MAX_LAYERS, strokesOf } from 'furrow/internal'
import { setAreaSize } from './area-size.ts'
import { blankDocument } from './blank.ts'
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

/** Map of an automatic layer that a document stores as an image. The other maps are drawn from strokes. */
export interface AutoMaps<Image> {
  readonly blood: Image
}

/** Returns the maps to store for each layer, with half the width and height of the normals, as in `furrow auto`. */
export function autoMaps({ blood }: Pick<AutoWrinkles, 'blood'>): AutoMaps<GrayImage>[] {
  return blood.maps.map((map) => ({ blood: halfSide(map) }))
}

type Driver = StudioDocument['drivers'][number]

/** Layer names that `autoWrinkles` assigns. */
const AUTOMATIC_LAYER = /^auto\d$/

/**
 * Makes a document from automatic wrinkles.
 *
 * @param names names of the mesh and the material.
 * @param images encoded maps of each layer. Omit them for previews, which show the maps of `wrinkles` directly.
 */
export function automaticDocument(
  wrinkles: AutoWrinkles,
  auto: AutoSettings,
  names: Pick<StudioDocument, 'mesh' | 'material'>,
  images: readonly AutoMaps<ImageFile>[] = [],
): StudioDocument {
  const { layers, areas, jointAreas, blood, bulges, scale } = wrinkles
  const all = [...areas, ...jointAreas, ...blood.areas, ...bulges]
  const isAutomatic = true
  return {
    ...names,
    scale,
    // Maps of cloth can be smaller than the settings demand.
    mapSize: layers[0]?.normal.width ?? auto.size,
    areaSize: all[0]?.weights.width ?? DEFAULT_AREA_SIZE,
    layers: layers.map(
      ({ name, onset }, i): StudioLayer => ({
        ...LAYER_DEFAULTS,
        name,
        bloodAmplitude: blood.amplitude,
        ...(images[i] && { maps: images[i], isBloodAutomatic: true }),
        ...(onset && { isOnsetDrawn: true }),
      }),
    ),
    areas: all.map(({ name, layer, weights }): StudioArea => {
      return { name, layer: layers[layer].name, combine: 'sum', activation: 0, weights, isAutomatic }
    }),
    strokes: (strokesOf(wrinkles).strokes as LayerStroke[]).map((stroke) => ({ ...stroke, isAutomatic })),
    drivers: autoDrivers(wrinkles),
    auto,
  }
}

/** Makes a document without wrinkles, which removes the automatic ones in `remake`. */
export function withoutAutomatic(document: StudioDocument, auto: AutoSettings): StudioDocument {
  const { mesh, material, scale, mapSize, areaSize } = document
  const target = { ...(mesh !== undefined && { mesh }), ...(material !== undefined && { material }) }
  return { ...target, ...blankDocument(auto), scale, mapSize, areaSize }
}

/**
 * Replaces the automatic wrinkles of a document by those in `newest`. Keeps the artist's work: painted areas with their drivers and strokes,
 * edited strokes, and layers with imported images.
 */
export function remake(document: StudioDocument, newest: StudioDocument): StudioDocument {
  // The size may have changed while the wrinkles were made. A document without areas gets the size that suits the joints.
  const made = document.areas.length > 0 ? setAreaSize(newest, document.areaSize) : newest
  const painted = new Set(document.areas.flatMap(({ name, isAutomatic }) => (isAutomatic ? [] : name)))
  // If the artist has edited one stroke of a group, keep all strokes of the group. Otherwise new strokes would cross the edited stroke, and the
  // strokes of a fork would no longer meet.
  const keptGroups = new Set(
    document.strokes.flatMap(({ isAutomatic, group }) =>
      !isAutomatic || (group !== undefined && painted.has(group)) ? [group] : [],
    ),
  )
  const stays = ({ group }: LayerStroke) => keptGroups.has(group)
  const kept = document.strokes.filter(stays)
  const strokes = [
    ...kept,
    ...made.strokes.filter((stroke) => !stays(stroke) && !painted.has(stroke.group ?? '')),
  ]
  // An automatic area stays if it surrounds kept strokes. A new area would surround the new strokes instead.
  const keptAreas = document.areas.filter(
    ({ name }) => painted.has(name) || kept.some((stroke) => isInGroupOf(stroke, name)),
  )
  const keptNames = new Set(keptAreas.map(({ name }) => name))
  const areas = [...keptAreas, ...made.areas.filter(({ name }) => !keptNames.has(name))]
  const madeNames = new Set(made.areas.map(({ name }) => name))
  /** Whether the old drivers of an area stay. Automatic areas get new drivers, if there are any. */
  const hasOldDrivers = (name: string) => painted.has(name) || (keptNames.has(name) && !madeNames.has(name))
  // Strokes are drawn over imported images, so the maps keep the size of the images.
  const hasImages = document.layers.some(hasOwnMaps)
  const layers = joinedLayers(document, made, areas, strokes)
  return {
    ...made,
    ...(hasImages && { mapSize: document.mapSize }),
    ...(document.furrows && { furrows: document.furrows }),
    ...(document.shapes && { shapes: document.shapes }),
    ...(document.takes && { takes: document.takes }),
    ...shapesOf(document, keptNames),
    areas: restoreLayers(areas, document, strokes),
    strokes,
    layers: layers.length > 0 ? layers : made.layers,
    drivers: [
      ...document.drivers
        .filter((driver) => {
          const area = areaOf(driver)
          return area === undefined ? driver.type !== 'expression' : hasOldDrivers(area)
        })
        .map((driver) => withAgeOf(made, driver)),
      ...made.drivers.filter((driver) => !hasOldDrivers(areaOf(driver) ?? '')),
    ],
  }
}

/** Returns a driver with the age of a document. Of all drivers of type `age`, only the age of the first one counts. */
function withAgeOf({ auto }: StudioDocument, driver: Driver): Driver {
  return driver.type === 'age' && auto?.age !== undefined ? { ...driver, initial: auto.age } : driver
}

/** Returns the maximum number of automatic layers: `MAX_LAYERS` minus the artist's own layers. Throws FurrowError if it is 0. */
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

/** If `remake` has kept a stroke of an automatic area, moves the area to the layer of the stroke. */
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

/** Whether a stroke belongs to an area. A left and a right area can share one group. The name of the group then has no side. */
function isInGroupOf({ group }: LayerStroke, area: string): boolean {
  return group === area || group === area.replace(/(Left|Right)$/, '')
}

/** Whether a layer has images or sculpted heights that `autoWrinkles` did not make. */
function hasOwnMaps({ maps, isBloodAutomatic, sculpted }: StudioLayer): boolean {
  return sculpted !== undefined || Object.keys(maps).some((map) => map !== 'blood' || !isBloodAutomatic)
}

/**
 * Joins the layers of two documents. Keeps each layer of `document` that an area or stroke uses, or that has imported images. If `made` has a
 * layer with the same name, takes the blood map and the setting `isOnsetDrawn` from it, but keeps imported blood and onset maps. Then appends
 * layers of `made` that are used and have new names.
 */
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
      return other ? drawOnset(other, copyBlood(other, layer, hasSameStrength)) : layer
    })
  const names = new Set(old.map(({ name }) => name))
  return [...old, ...made.layers.filter(({ name }) => !names.has(name) && used.has(name))].slice(
    0,
    MAX_LAYERS,
  )
}

/** Copies the blood map of a layer to `layer`, unless `layer` has an imported one. @param hasSameStrength whether `layer` keeps its amplitude. */
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

/** Sets `isOnsetDrawn` of `layer` if the first layer has it set. Does nothing if `layer` has an imported onset map. */
function drawOnset({ isOnsetDrawn }: StudioLayer, layer: StudioLayer): StudioLayer {
  return isOnsetDrawn && !layer.maps.onset ? { ...layer, isOnsetDrawn } : layer
}
