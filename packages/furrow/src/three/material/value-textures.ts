import { isSlice } from '../../core/check-areas.ts'
import type { ArraySlice, Layer } from '../../core/types.ts'
import { VALUE_KINDS, type ValueKind } from '../../runtime/layer-maps.ts'
import { PAIR, packPair } from '../../runtime/paired-maps.ts'
import { type LayerMaps, layerMaps, packedLayerMaps } from './layer-textures.ts'
import { mapTexture } from './textures.ts'

/**
 * Creates the textures of all layer maps except normals.
 *
 * @throws FurrowError as `createTextures` does.
 */
export function valueTextures(
  layers: readonly Layer<ArraySlice>[],
  anisotropy: number,
): Partial<Record<ValueKind, LayerMaps>> {
  const pair = pairMaps(layers, anisotropy)
  const values = VALUE_KINDS.flatMap((kind) => {
    const maps = pair?.[kind as PairedKind] ?? layerMaps(layers, kind, anisotropy)
    return maps ? [[kind, maps]] : []
  })
  return Object.fromEntries(values)
}

type PairedKind = (typeof PAIR)[number]

/** Packs occlusion and blood into one texture. Returns undefined unless the layers have images of both. */
function pairMaps(
  layers: readonly Layer<ArraySlice>[],
  anisotropy: number,
): Record<PairedKind, LayerMaps> | undefined {
  const isPaired = PAIR.every((kind) => layers.some((layer) => layer[kind]))
  if (!isPaired || layers.some((layer) => PAIR.some((kind) => isSlice(layer[kind])))) return undefined
  const { occlusion, blood } = packPair(layers as readonly Layer[])
  const texture = mapTexture(occlusion.images, anisotropy)
  return { occlusion: packedLayerMaps(occlusion, texture), blood: packedLayerMaps(blood, texture) }
}
