import type { ValueKind } from './layer-maps.ts'

/** Locations of all maps of one kind, such as roughness, in the textures of a shader. */
export interface ValueLayers {
  /** For each layer, the slice that stores its map; null if the layer has no such map. */
  readonly slices: readonly (number | null)[]
  readonly channel: number
  /** Kind of map after which the sampler is named. Occlusion and blood may share a sampler. */
  readonly sampler: ValueKind
}

/** A texel that shaders fetch once. Its channels may store values of several kinds of maps. */
export interface ValueTexel {
  /** Name of the shader variable. */
  name: string
  sampler: ValueKind
  slice: number
}

/** Lists the texels that shaders fetch. Each slice of an array is listed once. */
export function listTexels(values: Readonly<Partial<Record<ValueKind, ValueLayers>>>): ValueTexel[] {
  const all = Object.values(values)
  const samplers = [...new Set(all.map(({ sampler }) => sampler))]
  return samplers.flatMap((sampler) => {
    const sharing = all.filter((other) => other.sampler === sampler).map(({ slices }) => slices)
    const slices = new Set(sharing.flat().filter((slice) => slice !== null))
    return [...slices].map((slice) => ({ name: texelOf(sampler, slice), sampler, slice }))
  })
}

/** Returns the name of the shader variable for the texel of a slice. */
export function texelOf(sampler: ValueKind, slice: number): string {
  return `furrowTexel_${sampler}_${slice}`
}
