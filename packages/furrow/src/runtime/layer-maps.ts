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
 * Packs the images of one kind. A single one is not copied, which would take as much memory again.
 *
 * @param maps of each layer, all of one size; undefined for a layer that has none.
 */
export function packMaps(
  maps: readonly (RgbaImage | GrayImage | undefined)[],
  kind: 'normal' | ValueKind,
): PackedMaps {
  const present = maps.filter((map) => map !== undefined)
  const channels = kind === 'normal' || kind === 'baseColor' ? 4 : 1
  let next = 0
  return {
    images: present.length > 1 ? imageArray(present, channels) : { ...present[0], depth: 1, channels },
    slices: maps.map((map) => (map ? next++ : null)),
    channel: 0,
  }
}

/** Copies a layer's images, whose texels may become those of textures. */
export function copyMaps(layer: Layer<ArraySlice>): Layer<ArraySlice> {
  const copies = MAP_KINDS.flatMap((kind) => {
    const map = layer[kind]
    return map && !isSlice(map) ? [[kind, { ...map, data: new Uint8Array(map.data) }]] : []
  })
  return { ...layer, ...Object.fromEntries(copies) }
}
