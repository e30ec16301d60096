import { isSlice } from '../core/check-areas.ts'
import { type ImageArray, imageArray } from '../core/image-array.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../core/types.ts'

/** Kinds of maps that a layer may have besides its normals. */
export const VALUE_KINDS = ['baseColor', 'roughness', 'occlusion', 'blood'] as const
export type ValueKind = (typeof VALUE_KINDS)[number]

/** All kinds of maps that shaders mix. */
export const MAP_KINDS = ['normal', ...VALUE_KINDS] as const

/** The images of one kind of map, of all layers, as one array. */
export interface PackedMaps {
  images: ImageArray
  /** Slice of each layer's map; null for a layer that has none. */
  slices: readonly (number | null)[]
  /** Channel of single-channel maps. */
  channel: number
}

/**
 * Packs the images of one kind. Their texels are those of the array then, since a copy would take as much memory again; but not those of an image that several layers have.
 *
 * @param maps of each layer, all of one size; undefined for a layer that has none.
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

/** Copies layers for `packMaps`. Texels are copied of images that are alone in their kind, since those of others are when they are packed. */
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
