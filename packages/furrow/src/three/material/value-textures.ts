import { isSlice } from '../../core/check-areas.ts'
import type { ArraySlice, Layer } from '../../core/types.ts'
import { VALUE_KINDS, type ValueKind } from '../../runtime/maps/layer-maps.ts'
import { packShared, SHARED_KINDS, type SharedKind } from '../../runtime/maps/shared-maps.ts'
import { type LayerMaps, layerMaps, packedLayerMaps } from './layer-textures.ts'
import { mapTexture } from './textures.ts'

/**
 * Creates the textures of all layer maps except normals. Returns them by kind of map.
 *
 * @throws FurrowError as `createTextures` does.
 */
export function valueTextures(
  layers: readonly Layer<ArraySlice>[],
  anisotropy: number,
): Partial<Record<ValueKind, LayerMaps>> {
  const shared = sharedMaps(layers, anisotropy)
  const values = VALUE_KINDS.flatMap((kind) => {
    const maps = shared[kind as SharedKind] ?? layerMaps(layers, kind, anisotropy)
    return maps ? [[kind, maps]] : []
  })
  return Object.fromEntries(values)
}

/** Packs occlusion, blood and onset into one texture. Returns no maps if the layers have images of fewer than two of these kinds. */
function sharedMaps(
  layers: readonly Layer<ArraySlice>[],
  anisotropy: number,
): Partial<Record<SharedKind, LayerMaps>> {
  if (layers.some((layer) => SHARED_KINDS.some((kind) => isSlice(layer[kind])))) return {}
  const packed = Object.entries(packShared(layers as readonly Layer[]))
  if (packed.length === 0) return {}
  const texture = mapTexture(packed[0][1].images, anisotropy)
  return Object.fromEntries(packed.map(([kind, maps]) => [kind, packedLayerMaps(maps, texture)]))
}
