import type { Texture } from '@babylonjs/core/Materials/Textures/texture.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { Layer } from '../core/types.ts'
import { type PackedMaps, packMaps, VALUE_KINDS, type ValueKind } from '../runtime/maps/layer-maps.ts'
import { packShared, type SharedKind } from '../runtime/maps/shared-maps.ts'
import type { ValueLayers } from '../runtime/maps/value-texels.ts'
import type { MixedLayers } from './shaders/mixing.ts'
import { colourTexture, mapTexture } from './textures.ts'

/** Textures with the maps of all layers of a wrinkle set. */
export interface LayerTextures {
  /** Parameters for generating the shader. */
  readonly mixed: MixedLayers
  /** Textures by kind of map. Occlusion, blood and onset can share a texture, stored under the first kind that the set has. */
  readonly textures: Readonly<Partial<Record<'normal' | ValueKind, Texture>>>
  /** One number per layer, padded to four. */
  readonly normalScale: readonly number[]
  readonly occlusionStrength: readonly number[]
  readonly bloodAmplitude: readonly number[]
  readonly onsetStrength: readonly number[]
}

/**
 * Creates textures with the maps of layers.
 *
 * @param layers layers of a set. All maps of one kind have the same size.
 * @param anisotropy anisotropic filtering level of the textures.
 */
export function createTextures(layers: readonly Layer[], anisotropy: number, scene: Scene): LayerTextures {
  const normals = packMaps(
    layers.map(({ normal }) => normal),
    'normal',
  )
  const packed = packValues(layers)
  const textures: Partial<Record<'normal' | ValueKind, Texture>> = {
    normal: mapTexture(normals.images, anisotropy, scene),
  }
  const values: Partial<Record<ValueKind, ValueLayers>> = {}
  for (const [kind, { images, slices, channel }] of packed) {
    const [sampler] = packed.find(([, maps]) => maps.images === images)!
    values[kind] = { slices, channel, sampler }
    const create = kind === 'baseColor' ? colourTexture : mapTexture
    if (sampler === kind) textures[kind] = create(images, anisotropy, scene)
  }
  return {
    mixed: { kinds: layers.map(({ kind }) => kind), normals: normals.slices, values },
    textures,
    normalScale: perLayer(layers.map(({ normalScale }) => normalScale ?? 1)),
    occlusionStrength: perLayer(layers.map(({ occlusionStrength }) => occlusionStrength ?? 1)),
    bloodAmplitude: perLayer(layers.map(({ bloodAmplitude }) => bloodAmplitude ?? 0)),
    onsetStrength: perLayer(layers.map(({ onsetStrength }) => onsetStrength ?? 1)),
  }
}

function packValues(layers: readonly Layer[]): [ValueKind, PackedMaps][] {
  const shared = packShared(layers)
  return VALUE_KINDS.flatMap((kind): [ValueKind, PackedMaps][] => {
    const maps = layers.map((layer) => layer[kind])
    if (!maps.some(Boolean)) return []
    return [[kind, shared[kind as SharedKind] ?? packMaps(maps, kind)]]
  })
}

function perLayer(numbers: readonly number[]): number[] {
  return [...numbers, 1, 1, 1].slice(0, 4)
}
