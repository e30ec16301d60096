import { type CompressedArrayTexture as Compressed, CompressedArrayTexture } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'

/** Maps that become one array. */
const GROUPS = [['normal'], ['baseColor'], ['roughness'], ['occlusion', 'blood']] as const

/**
 * Joins separate compressed images of one kind of map into one array, since shaders read them through one sampler; blocks are copied as
 * they are. Uncompressed images are left alone.
 *
 * @returns a set whose slices of one kind are in one array.
 * @throws FurrowError when maps of a kind differ in size, format or mipmaps.
 */
export function joinArrays({ layers, areas }: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  const joined = layers.map((layer) => ({ ...layer }))
  // Occlusion and roughness may be channels of the same images, and then use the same array.
  const known = new Map<string, Compressed>()
  for (const kinds of GROUPS) {
    const sliced = joined.flatMap((layer) =>
      kinds.filter((kind) => isSlice(layer[kind])).map((kind) => ({ layer, kind })),
    )
    const slices = join(
      sliced.map(({ layer, kind }) => layer[kind]) as ArraySlice[],
      `${kinds[0]} maps`,
      known,
    )
    for (const [i, { layer, kind }] of sliced.entries()) Object.assign(layer, { [kind]: slices[i] })
  }
  const slicedAreas = areas.filter(({ weights }) => isSlice(weights))
  const weights = join(slicedAreas.map((area) => area.weights) as ArraySlice[], 'areas', known)
  const weightsOf = new Map(slicedAreas.map((area, i) => [area, weights[i]]))
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
  const offsets = arrays.map((_, i) => arrays.slice(0, i).reduce((sum, { image }) => sum + image.depth, 0))
  return maps.map((map) => ({
    ...map,
    array,
    slice: offsets[arrays.indexOf(map.array as Compressed)] + map.slice,
  }))
}

function concatenate(arrays: readonly Compressed[], what: string): Compressed {
  const [first] = arrays
  const other = arrays.find((array) => layoutOf(array) !== layoutOf(first))
  if (other) {
    throw new FurrowError({
      who: WRINKLE_MAPS,
      problem: `${what} with different layouts`,
      value: layoutOf(other),
      limit: layoutOf(first),
      remedy: 'give all of a kind one size and one encoding, or let `furrow pack --ktx2` do it',
    })
  }
  const mipmaps = first.mipmaps!.map(({ width, height }, level) => ({
    width,
    height,
    data: concatenateBytes(arrays.map((array) => array.mipmaps![level].data as Uint8Array)),
  }))
  const depth = arrays.reduce((sum, { image }) => sum + image.depth, 0)
  const { width, height } = first.image
  const array = new CompressedArrayTexture(mipmaps, width, height, depth, first.format, first.type)
  const { minFilter, magFilter, wrapS, wrapT, colorSpace } = first
  return Object.assign(array, { minFilter, magFilter, wrapS, wrapT, colorSpace, needsUpdate: true })
}

/** Size, number of mipmaps and format (three.js's constant), for errors. */
function layoutOf({ image, mipmaps, format, colorSpace }: Compressed): string {
  const encoding = `${colorSpace || 'linear'} format ${format}`
  return `${image.width} x ${image.height} with ${mipmaps?.length} levels, ${encoding}`
}

function concatenateBytes(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
  let offset = 0
  for (const part of parts) {
    whole.set(part, offset)
    offset += part.length
  }
  return whole
}
