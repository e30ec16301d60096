import type { Texture } from '@babylonjs/core/Materials/Textures/texture.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { Layer } from '../core/types.ts'
import { type PackedMaps, packMaps, VALUE_KINDS, type ValueKind } from '../runtime/layer-maps.ts'
import { PAIR, packPair } from '../runtime/paired-maps.ts'
import type { ValueLayers } from '../runtime/value-texels.ts'
import type { MixedLayers } from './shaders/mixing.ts'
import { colourTexture, mapTexture } from './textures.ts'

/** Textures of a set's layer maps. */
export interface LayerTextures {
  /** Shader parameters. */
  readonly mixed: MixedLayers
  /** Textures by kind of map; occlusion and blood may share the texture of `occlusion`. */
  readonly textures: Readonly<Partial<Record<'normal' | ValueKind, Texture>>>
  /** Normal scale, occlusion strength and blood amplitude per layer. */
  readonly normalScale: readonly number[]
  readonly occlusionStrength: readonly number[]
  readonly bloodAmplitude: readonly number[]
}

/**
 * Creates the textures of a set's layers.
 *
 * @param layers layers whose maps of each kind have one size.
 * @param anisotropy anisotropy of the base map.
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
  }
}

function packValues(layers: readonly Layer[]): [ValueKind, PackedMaps][] {
  const isPaired = PAIR.every((kind) => layers.some((layer) => layer[kind]))
  const pair: Partial<Record<ValueKind, PackedMaps>> = isPaired ? packPair(layers) : {}
  return VALUE_KINDS.flatMap((kind): [ValueKind, PackedMaps][] => {
    const maps = layers.map((layer) => layer[kind])
    if (!maps.some(Boolean)) return []
    return [[kind, pair[kind] ?? packMaps(maps, kind)]]
  })
}

function perLayer(numbers: readonly number[]): number[] {
  return [...numbers, 1, 1, 1].slice(0, 4)
}
