import { BLOOD_AT_REST } from '../core/blood.ts'
import { packPairs } from '../core/pack-pairs.ts'
import type { GrayImage, Layer } from '../core/types.ts'
import type { PackedMaps } from './layer-maps.ts'

/** Kinds of maps that share one array as channels, to save samplers. */
export const PAIR = ['occlusion', 'blood'] as const

/** Packs the occlusion and blood images of layers into one array. */
export function packPair(layers: readonly Layer[]): Record<(typeof PAIR)[number], PackedMaps> {
  const owners = layers.filter(({ occlusion, blood }) => occlusion ?? blood)
  const pairs = owners.map(({ occlusion, blood }): [GrayImage | undefined, GrayImage | undefined] => [
    occlusion,
    blood,
  ])
  const images = packPairs(pairs, [255, BLOOD_AT_REST])
  const mapsOf = (kind: (typeof PAIR)[number]): PackedMaps => ({
    images,
    slices: layers.map((layer) => (layer[kind] ? owners.indexOf(layer) : null)),
    channel: PAIR.indexOf(kind),
  })
  return { occlusion: mapsOf('occlusion'), blood: mapsOf('blood') }
}
