import { isSlice } from '../../core/check-areas.ts'
import { type ImageArray, imageArray } from '../../core/image-array.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../../core/types.ts'

/** Kinds of optional maps in a layer. Height maps are not listed, because materials do not sample them. */
export const VALUE_KINDS = ['baseColor', 'roughness', 'occlusion', 'blood', 'onset'] as const
export type ValueKind = (typeof VALUE_KINDS)[number]

/** Kinds of maps that are mixed into values of the material. Onset maps change the influence of layers instead. */
export type MixedKind = Exclude<ValueKind, 'onset'>

/** Kinds of maps that materials sample. */
export const MAP_KINDS = ['normal', ...VALUE_KINDS] as const

/** Maps of one kind from all layers, packed into one array. */
export interface PackedMaps {
  images: ImageArray
  /** For each layer, the slice that stores its map; null if the layer has no such map. */
  slices: readonly (number | null)[]
  /** Channel that stores single-channel maps, 0 = first. */
  channel: number
}

/**
 * Packs all maps of one kind into one array. To save memory, the `data` of each map is replaced by a view of the array, unless several
 * layers share the map.
 *
 * @param maps one map per layer, or undefined for layers without this kind. All maps have the same size.
 */
export function packMaps(
  maps: readonly (RgbaImage | GrayImage | undefined)[],
  kind: 'normal' | ValueKind,
): PackedMaps {
  const present = maps.filter((map) => map !== undefined)
  const channels = kind === 'normal' || kind === 'baseColor' ? 4 : 1
  const images: ImageArray =
    present.length > 1 ? imageArray(present, channels) : { ...present[0], depth: 1, channels }
  const bytes = images.data.length / present.length
  for (const [i, map] of present.entries()) {
    const isShared = present.indexOf(map) !== present.lastIndexOf(map)
    if (!isShared) map.data = images.data.subarray(i * bytes, (i + 1) * bytes)
  }
  let next = 0
  return {
    images,
    slices: maps.map((map) => (map ? next++ : null)),
    channel: 0,
  }
}

/**
 * Copies layers, because `packMaps` changes their maps. If only one layer has a map of some kind, the texels of this map are copied too.
 * If several layers have such a map, `packMaps` copies the texels.
 */
export function copyLayers(layers: readonly Layer<ArraySlice>[]): Layer<ArraySlice>[] {
  const isAlone = (kind: (typeof MAP_KINDS)[number]) => layers.filter((layer) => layer[kind]).length === 1
  return layers.map((layer) => {
    const copies = MAP_KINDS.flatMap((kind) => {
      const map = layer[kind]
      if (!map || isSlice(map)) return []
      return [[kind, { ...map, data: isAlone(kind) ? new Uint8Array(map.data) : map.data }]]
    })
    return { ...layer, ...Object.fromEntries(copies) }
  })
}
