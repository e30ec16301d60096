import { NoColorSpace, SRGBColorSpace, Vector4 } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import type { ArraySlice, GrayImage, Layer, LayerKind, RgbaImage } from '../../core/types.ts'
import { type PackedMaps, packMaps, VALUE_KINDS, type ValueKind } from '../../runtime/layer-maps.ts'
import { type ArrayTexture, arrayOf, type Upload } from './array-texture.ts'
import type { Channels } from './channels.ts'
import { mapTexture } from './textures.ts'

export { VALUE_KINDS, type ValueKind }

/** One kind of map of all layers, as one array on the GPU. */
export interface LayerMaps {
  texture: ArrayTexture
  /** Slice of each layer's map; null for a layer that has none. */
  slices: readonly (number | null)[]
  /** Channel of single-channel maps, 0 = R to 3 = A. */
  channel: number
}

/** The maps of a set's layers on the GPU, which several faces may use; see `retain` and `release`. */
export interface WrinkleTextures {
  readonly layers: Layer<ArraySlice>[]
  readonly kinds: readonly LayerKind[]
  readonly normals: LayerMaps
  readonly values: Readonly<Partial<Record<ValueKind, LayerMaps>>>
  /** Scale of normals, strength of occlusion and amplitude of blood, per layer: uniforms that all faces with these textures read. */
  readonly normalScale: { value: Vector4 }
  readonly occlusionStrength: { value: Vector4 }
  readonly bloodAmplitude: { value: Vector4 }
  /** Incremented when maps or their strengths change. */
  version: number
  /** Uploads maps that changed; set by `updateLayer`. */
  upload?: Upload
}

/**
 * Creates the textures of a set's layers.
 *
 * @param anisotropy that of the map they are mixed with.
 * @param channels where `needChannels` says so.
 * @throws FurrowError when maps of one kind differ in size, or are in several arrays.
 */
export function createTextures(
  layers: readonly Layer<ArraySlice>[],
  anisotropy: number,
  channels: Channels | null,
): WrinkleTextures {
  const normals = layerMaps(layers, 'normal', anisotropy)!
  const kinds = layers.map(({ kind }) => kind)
  return {
    layers: [...layers],
    kinds,
    normals,
    values: channels?.valueTextures(layers, anisotropy) ?? {},
    normalScale: { value: perLayer(layers.map(({ normalScale }) => normalScale ?? 1)) },
    occlusionStrength: { value: perLayer(layers.map(({ occlusionStrength }) => occlusionStrength ?? 1)) },
    bloodAmplitude: { value: perLayer(layers.map(({ bloodAmplitude }) => bloodAmplitude ?? 0)) },
    version: 0,
  }
}

function perLayer(numbers: readonly number[]): Vector4 {
  return new Vector4().fromArray([...numbers, 1, 1, 1])
}

/** All textures of a set's layers, each once. */
export function listTextures({ normals, values }: WrinkleTextures): ArrayTexture[] {
  return [...new Set([normals, ...Object.values(values)].map(({ texture }) => texture))]
}

type Map = RgbaImage | GrayImage | ArraySlice

/** The maps of one kind; undefined where no layer has any. */
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
    return onGpu(packed, mapTexture(packed.images, anisotropy, space))
  }
  const texture = arrayOf(present, 'Wrinkles', `${kind} maps`)
  texture.anisotropy = anisotropy
  const slices = maps.map((map) => (isSlice(map) ? map.slice : null))
  return { texture, slices, channel: (present[0] as ArraySlice).channel }
}

/** Maps that were packed, on the GPU. */
export function onGpu({ slices, channel }: PackedMaps, texture: ArrayTexture): LayerMaps {
  return { texture, slices, channel }
}
