import { Vector4 } from 'three'
import type { ArraySlice, Layer, LayerKind } from '../../core/types.ts'
import { VALUE_KINDS, type ValueKind } from '../../runtime/maps/layer-maps.ts'
import type { ArrayTexture, Upload } from './array-texture.ts'
import { type LayerMaps, layerMaps } from './layer-textures.ts'
import { valueTextures } from './value-textures.ts'

export { type LayerMaps, VALUE_KINDS, type ValueKind }

/** Textures with the layer maps of a wrinkle set. Several faces share them, so their users are counted; see `retain` and `release`. */
export interface WrinkleTextures {
  readonly layers: Layer<ArraySlice>[]
  readonly kinds: readonly LayerKind[]
  readonly normals: LayerMaps
  readonly values: Readonly<Partial<Record<ValueKind, LayerMaps>>>
  /** Normal scale per layer. All faces with these textures share this uniform and the next three uniforms. */
  readonly normalScale: { value: Vector4 }
  readonly occlusionStrength: { value: Vector4 }
  readonly bloodAmplitude: { value: Vector4 }
  readonly onsetStrength: { value: Vector4 }
  /** Incremented when maps or their strengths change. */
  version: number
  /** Uploads changed maps; set by `updateLayer`. */
  upload?: Upload
}

/**
 * Creates the textures of a set's layers.
 *
 * @param layers layers. All images of one kind must have the same size.
 * @param anisotropy anisotropy of the material's normal map.
 * @throws FurrowError if maps of one kind are in several texture arrays.
 */
export function createTextures(layers: readonly Layer<ArraySlice>[], anisotropy: number): WrinkleTextures {
  const normals = layerMaps(layers, 'normal', anisotropy)!
  const kinds = layers.map(({ kind }) => kind)
  return {
    layers: [...layers],
    kinds,
    normals,
    values: valueTextures(layers, anisotropy),
    normalScale: { value: perLayer(layers.map(({ normalScale }) => normalScale ?? 1)) },
    occlusionStrength: { value: perLayer(layers.map(({ occlusionStrength }) => occlusionStrength ?? 1)) },
    bloodAmplitude: { value: perLayer(layers.map(({ bloodAmplitude }) => bloodAmplitude ?? 0)) },
    onsetStrength: { value: perLayer(layers.map(({ onsetStrength }) => onsetStrength ?? 1)) },
    version: 0,
  }
}

function perLayer(numbers: readonly number[]): Vector4 {
  return new Vector4().fromArray([...numbers, 1, 1, 1])
}

/** Returns each texture once, although several kinds of maps may share one texture. */
export function listTextures({ normals, values }: WrinkleTextures): ArrayTexture[] {
  return [...new Set([normals, ...Object.values(values)].map(({ texture }) => texture))]
}
