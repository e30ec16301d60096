import { NoColorSpace, SRGBColorSpace } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../../core/types.ts'
import { type PackedMaps, packMaps, type ValueKind } from '../../runtime/maps/layer-maps.ts'
import { type ArrayTexture, arrayOf } from './array-texture.ts'
import { mapTexture } from './textures.ts'

/** The maps of one kind, e.g. normals, of all layers in one texture array. */
export interface LayerMaps {
  texture: ArrayTexture
  /** Slice of each layer's map; null if the layer has no such map. */
  slices: readonly (number | null)[]
  /** Channel of single-channel maps, 0 = R to 3 = A. */
  channel: number
}

type Map = RgbaImage | GrayImage | ArraySlice

/** Creates the texture array for one kind of map; returns undefined if no layer has a map of this kind. */
export function layerMaps(
  layers: readonly Layer<ArraySlice>[],
  kind: 'normal' | ValueKind,
  anisotropy: number,
): LayerMaps | undefined {
  const maps = layers.map((layer): Map | undefined => layer[kind])
  const present = maps.filter((map): map is Map => map !== undefined)
  if (present.length === 0) return undefined
  if (!present.some(isSlice)) {
    const packed = packMaps(maps as (RgbaImage | GrayImage | undefined)[], kind)
    const space = kind === 'baseColor' ? SRGBColorSpace : NoColorSpace
    return packedLayerMaps(packed, mapTexture(packed.images, anisotropy, space))
  }
  const texture = arrayOf(present, 'Wrinkles', `${kind} maps`)
  texture.anisotropy = anisotropy
  const slices = maps.map((map) => (isSlice(map) ? map.slice : null))
  return { texture, slices, channel: (present[0] as ArraySlice).channel }
}

export function packedLayerMaps({ slices, channel }: PackedMaps, texture: ArrayTexture): LayerMaps {
  return { texture, slices, channel }
}
