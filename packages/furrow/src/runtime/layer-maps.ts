import { isSlice } from '../core/check-areas.ts'
import { type ImageArray, imageArray } from '../core/image-array.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../core/types.ts'

/** Kinds of optional maps in a layer, besides normals. */
export const VALUE_KINDS = ['baseColor', 'roughness', 'occlusion', 'blood'] as const
export type ValueKind = (typeof VALUE_KINDS)[number]

/** Kinds of maps that shaders mix. */
export const MAP_KINDS = ['normal', ...VALUE_KINDS] as const

/** Images of one kind of map from all layers, in one array. */
export interface PackedMaps {
  images: ImageArray
  /** Slice of each layer's map; null for layers without one. */
  slices: readonly (number | null)[]
  /** Channel of single-channel maps. */
  channel: number
}

/**
 * Packs the images of one kind. To save memory, images then alias the array, unless several layers share them.
 *
 * @param maps map of each layer, all of one size; undefined for layers without one.
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

/** Copies layers for `packMaps`. Copies only texels of images that are alone in their kind, because packing copies the others. */
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
