import { areaWeights, type GrayImage, type WrinkleSetDocument } from 'furrow'
import { parseCorrections, type ShapeCorrection } from 'furrow/internal'
import { decodeGray } from '../images/decode-gray.ts'
import type { Pixels } from '../images/pixels.ts'
import { WRINKLES_FILE } from '../wrinkles/folder-document.ts'
import { MAP_SLOTS, type MapName } from '../wrinkles/map-slots.ts'
import { readStrokes, type StoredStrokes } from '../wrinkles/strokes.ts'

type LayerEntry = WrinkleSetDocument['layers'][number]
type AreaEntry = WrinkleSetDocument['areas'][number]

/** A wrinkle set with functions that load its images, so that they need not be in memory at once. */
export interface SetToPack extends Pick<WrinkleSetDocument, 'mesh' | 'material' | 'areaSize' | 'drivers'> {
  layers: readonly LayerToPack[]
  areas: readonly AreaToPack[]
  strokes?: () => Promise<StoredStrokes>
  /** Corrections of recognised blendshapes. */
  shapes?: readonly ShapeCorrection[]
}

/** A layer of `wrinkles.json` with functions that load its maps. */
export interface LayerToPack extends Omit<LayerEntry, MapName> {
  maps: { [Name in MapName]?: () => Promise<MapToPack> } & { normal(): Promise<MapToPack> }
}

/** A map: a PNG or JPEG file with its path for errors, or pixels to encode as PNG. */
export type MapToPack = { path: string; bytes: Uint8Array } | Pixels

/** An area of `wrinkles.json` with a function that loads its weights. */
export interface AreaToPack extends Omit<AreaEntry, 'image' | 'convention'> {
  weights(): Promise<GrayImage>
  /** Appended to the warning about an empty area. */
  hint?: string
}

/** Reads a file by its URI in the wrinkle set. */
export type ReadFile = (uri: string) => Promise<Uint8Array>

/** Returns the wrinkle set of a folder. Images are read during packing. */
export function setOfFolder(document: WrinkleSetDocument, read: ReadFile, who: string): SetToPack {
  const { mesh, material, areaSize, drivers, strokes } = document
  const names = document.layers.map(({ name }) => name)
  return {
    mesh,
    material,
    areaSize,
    drivers,
    shapes: parseCorrections(document.shapes, `${who}: ${WRINKLES_FILE}`),
    layers: document.layers.map((entry) => layerOfFolder(entry, read)),
    areas: document.areas.map(({ image, convention, ...area }) => ({
      ...area,
      weights: async () =>
        areaWeights(await decodeGray(await read(image), image, who), convention, `${who}: ${image}`),
      hint: `; is ${image} in the other convention (--white-is-visible)?`,
    })),
    ...(strokes !== undefined && {
      strokes: async () => readStrokes(await read(strokes), strokes, names, who),
    }),
  }
}

function layerOfFolder(entry: LayerEntry, read: ReadFile): LayerToPack {
  const { normal, baseColor, roughness, occlusion, height, blood, ...layer } = entry
  const maps = MAP_SLOTS.flatMap(([map]) => {
    const path = entry[map]
    return path === undefined ? [] : [[map, async () => ({ path, bytes: await read(path) })] as const]
  })
  return { ...layer, maps: Object.fromEntries(maps) as unknown as LayerToPack['maps'] }
}
