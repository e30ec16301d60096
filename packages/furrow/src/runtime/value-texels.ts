import type { ValueKind } from './layer-maps.ts'

/** One kind of the layers' other maps, as shaders depend on it. */
export interface ValueLayers {
  /** Slice of each layer's map; null for a layer without. */
  readonly slices: readonly (number | null)[]
  readonly channel: number
  /** The kind whose array holds these maps: its sampler is declared, and read for both. */
  readonly sampler: ValueKind
}

/** A texel that shaders read once, whatever number of kinds its channels hold, and however often they are mixed in. */
export interface ValueTexel {
  /** The variable that it is kept in. */
  name: string
  sampler: ValueKind
  slice: number
}

/** The texels of all kinds, each slice of an array once. */
export function listTexels(values: Readonly<Partial<Record<ValueKind, ValueLayers>>>): ValueTexel[] {
  const all = Object.values(values)
  const samplers = [...new Set(all.map(({ sampler }) => sampler))]
  return samplers.flatMap((sampler) => {
    const sharing = all.filter((other) => other.sampler === sampler).map(({ slices }) => slices)
    const slices = new Set(sharing.flat().filter((slice) => slice !== null))
    return [...slices].map((slice) => ({ name: texelOf(sampler, slice), sampler, slice }))
  })
}

/** The variable of a slice's texel. */
export function texelOf(sampler: ValueKind, slice: number): string {
  return `furrowTexel_${sampler}_${slice}`
}
