import { BLOOD_AT_REST } from '../../core/blood.ts'
import { packChannels } from '../../core/maps/pack-channels.ts'
import type { Layer } from '../../core/types.ts'
import type { PackedMaps } from './layer-maps.ts'

/** Kinds of maps that are stored in channels of one array, to save texture samplers. */
export const SHARED_KINDS = ['occlusion', 'blood', 'onset'] as const
export type SharedKind = (typeof SHARED_KINDS)[number]

/** For each kind, the byte that fills the channel of a missing map. */
const NEUTRAL: Record<SharedKind, number> = { occlusion: 255, blood: BLOOD_AT_REST, onset: 0 }

/**
 * Packs the occlusion, blood and onset images of layers into one array.
 *
 * @returns the packed maps by kind; empty if the layers have fewer than two of these kinds.
 */
export function packShared(layers: readonly Layer[]): Partial<Record<SharedKind, PackedMaps>> {
  const kinds = SHARED_KINDS.filter((kind) => layers.some((layer) => layer[kind]))
  if (kinds.length < 2) return {}
  const owners = layers.filter((layer) => kinds.some((kind) => layer[kind]))
  const images = packChannels(
    owners.map((layer) => kinds.map((kind) => layer[kind])),
    kinds.map((kind) => NEUTRAL[kind]),
  )
  return Object.fromEntries(
    kinds.map((kind, channel) => {
      const slices = layers.map((layer) => (layer[kind] ? owners.indexOf(layer) : null))
      return [kind, { images, slices, channel }]
    }),
  )
}
