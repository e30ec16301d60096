import { areaWeights, type GrayImage, type WrinkleSetDocument } from 'furrow'
import { parseCorrections, type ShapeCorrection } from 'furrow/internal'
import { decodeGray } from '../images/decode-gray.ts'
import type { Pixels } from '../images/pixels.ts'
import { WRINKLES_FILE } from '../wrinkles/folder-document.ts'
import { MAP_SLOTS, type MapName } from '../wrinkles/map-slots.ts'
import { readStrokes, type StoredStrokes } from '../wrinkles/strokes.ts'

type LayerEntry = WrinkleSetDocument['layers'][number]
type AreaEntry = WrinkleSetDocument['areas'][number]

/** A wrinkle set whose images are loaded one by one, to save memory. */
export interface SetToPack extends Pick<WrinkleSetDocument, 'mesh' | 'material' | 'areaSize' | 'drivers'> {
  layers: readonly LayerToPack[]
  areas: readonly AreaToPack[]
  strokes?: () => Promise<StoredStrokes>
  /** ARKit shapes that the user assigned to blendshapes. They override the automatic recognition. */
  shapes?: readonly ShapeCorrection[]
}

/** Layer of `wrinkles.json` with functions that load its maps. */
export interface LayerToPack extends Omit<LayerEntry, MapName | 'sculpted'> {
  maps: { [Name in MapName]?: () => Promise<MapToPack> } & { normal(): Promise<MapToPack> }
}

/** A map: the content and path of a PNG or JPEG file, or pixels to encode as PNG. */
export type MapToPack = { path: string; bytes: Uint8Array } | Pixels

/** Area of `wrinkles.json` with a function that loads its weights. */
export interface AreaToPack extends Omit<AreaEntry, 'image' | 'convention'> {
  weights(): Promise<GrayImage>
  /** Whether the area has no weights on purpose, because it only drives other areas. */
  isHidden?: boolean
  /** Text that is appended to the warning about an empty area. */
  hint?: string
}

/** Reads a file by its URI in `wrinkles.json`. */
export type ReadFile = (uri: string) => Promise<Uint8Array>

/** Converts the document of a folder. Images are read later, when `packSet` loads them. */
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
  const { normal, baseColor, roughness, occlusion, height, blood, onset, sculpted, ...layer } = entry
  const maps = MAP_SLOTS.flatMap(([map]) => {
    const path = entry[map]
    return path === undefined ? [] : [[map, async () => ({ path, bytes: await read(path) })] as const]
  })
  return { ...layer, maps: Object.fromEntries(maps) as unknown as LayerToPack['maps'] }
}
