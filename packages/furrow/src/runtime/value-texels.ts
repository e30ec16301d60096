import type { ValueKind } from './layer-maps.ts'

/** Shader inputs of one kind of optional maps. */
export interface ValueLayers {
  /** Slice of each layer's map; null for layers without one. */
  readonly slices: readonly (number | null)[]
  readonly channel: number
  /** Kind whose array and sampler hold these maps. */
  readonly sampler: ValueKind
}

/** A texel that shaders read once, for all kinds of maps in its channels. */
export interface ValueTexel {
  /** Shader variable. */
  name: string
  sampler: ValueKind
  slice: number
}

/** Lists the texels of all kinds; each slice of an array once. */
export function listTexels(values: Readonly<Partial<Record<ValueKind, ValueLayers>>>): ValueTexel[] {
  const all = Object.values(values)
  const samplers = [...new Set(all.map(({ sampler }) => sampler))]
  return samplers.flatMap((sampler) => {
    const sharing = all.filter((other) => other.sampler === sampler).map(({ slices }) => slices)
    const slices = new Set(sharing.flat().filter((slice) => slice !== null))
    return [...slices].map((slice) => ({ name: texelOf(sampler, slice), sampler, slice }))
  })
}

/** Returns the shader variable of a slice's texel. */
export function texelOf(sampler: ValueKind, slice: number): string {
  return `furrowTexel_${sampler}_${slice}`
}
