import { type CompressedArrayTexture as Compressed, CompressedArrayTexture } from 'three'
import { FurrowError } from '../../core/error.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { WRINKLE_MAPS } from '../../core/wrinkle-maps.ts'
import { isSlice } from '../../core/wrinkle-set.ts'
import { VALUE_KINDS } from '../material/wrinkle-textures.ts'

const KINDS = ['normal', ...VALUE_KINDS] as const

/**
 * Has all maps of a kind lie in one array, since a shader reads them through one sampler: compressed images that came each by
 * itself are put together, block by block. Images that are not compressed stay.
 *
 * @throws FurrowError where maps of a kind differ in size, format or mipmaps.
 */
export function joinArrays({ layers, areas }: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  const joined = layers.map((layer) => ({ ...layer }))
  // Occlusion and roughness may share their images, and then share the array.
  const known = new Map<string, Compressed>()
  for (const kind of KINDS) {
    const having = joined.filter((layer) => isSlice(layer[kind]))
    const slices = join(having.map((layer) => layer[kind]) as ArraySlice[], `${kind} maps`, known)
    for (const [i, layer] of having.entries()) Object.assign(layer, { [kind]: slices[i] })
  }
  const sliced = areas.filter(({ weights }) => isSlice(weights))
  const weights = join(sliced.map((area) => area.weights) as ArraySlice[], 'areas', known)
  const weightsOf = new Map(sliced.map((area, i) => [area, weights[i]]))
  return {
    layers: joined,
    areas: areas.map((area) => ({ ...area, weights: weightsOf.get(area) ?? area.weights })),
  }
}

function join(
  maps: readonly ArraySlice[],
  what: string,
  known: Map<string, Compressed>,
): readonly ArraySlice[] {
  const arrays = [...new Set(maps.map(({ array }) => array as Compressed))]
  if (arrays.length < 2) return maps
  const key = arrays.map(({ uuid }) => uuid).join()
  const array = known.get(key) ?? concatenate(arrays, what)
  known.set(key, array)
  const firsts = arrays.map((_, i) => arrays.slice(0, i).reduce((sum, { image }) => sum + image.depth, 0))
  return maps.map((map) => ({
    ...map,
    array,
    slice: firsts[arrays.indexOf(map.array as Compressed)] + map.slice,
  }))
}

function concatenate(arrays: readonly Compressed[], what: string): Compressed {
  const [first] = arrays
  const other = arrays.find((array) => layoutOf(array) !== layoutOf(first))
  if (other) {
    throw new FurrowError({
      who: WRINKLE_MAPS,
      what: `${what} that differ`,
      value: layoutOf(other),
      limit: layoutOf(first),
      remedy: 'give all of a kind one size and one encoding, or let `furrow pack --ktx2` do it',
    })
  }
  const mipmaps = first.mipmaps!.map(({ width, height }, level) => ({
    width,
    height,
    data: concatenated(arrays.map((array) => array.mipmaps![level].data as Uint8Array)),
  }))
  const depth = arrays.reduce((sum, { image }) => sum + image.depth, 0)
  const { width, height } = first.image
  const array = new CompressedArrayTexture(mipmaps, width, height, depth, first.format, first.type)
  const { minFilter, magFilter, wrapS, wrapT, colorSpace } = first
  return Object.assign(array, { minFilter, magFilter, wrapS, wrapT, colorSpace, needsUpdate: true })
}

/** Size, number of mipmaps and format (a number of three.js's), as an error can show it. */
function layoutOf({ image, mipmaps, format, colorSpace }: Compressed): string {
  const encoding = `${colorSpace || 'linear'} format ${format}`
  return `${image.width} x ${image.height} with ${mipmaps?.length} levels, ${encoding}`
}

function concatenated(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
  let offset = 0
  for (const part of parts) {
    whole.set(part, offset)
    offset += part.length
  }
  return whole
}
