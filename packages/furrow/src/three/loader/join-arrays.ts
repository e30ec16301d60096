import { type CompressedArrayTexture as Compressed, CompressedArrayTexture } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'

/** Groups of map kinds. All maps of a group are joined into one texture array. */
const GROUPS = [['normal'], ['baseColor'], ['roughness'], ['occlusion', 'blood', 'onset']] as const

/**
 * Joins the compressed maps of a wrinkle set into one texture array per group of map kinds, because shaders read each group through one
 * sampler. Also joins compressed areas. Copies the compressed data without decoding. Uncompressed images stay unchanged.
 *
 * @returns a copy of the set, with references to the joined arrays.
 * @throws FurrowError if maps of a kind differ in size, format or mipmaps.
 */
export function joinArrays({ layers, areas }: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  const joined = layers.map((layer) => ({ ...layer }))
  // Caches joined arrays. Occlusion and roughness may be channels of the same images; they then share one joined array.
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
  label: string,
  known: Map<string, Compressed>,
): readonly ArraySlice[] {
  const arrays = [...new Set(maps.map(({ array }) => array as Compressed))]
  if (arrays.length < 2) return maps
  const key = arrays.map(({ uuid }) => uuid).join()
  const array = known.get(key) ?? concatenate(arrays, label)
  known.set(key, array)
  const offsets = arrays.map((_, i) => arrays.slice(0, i).reduce((sum, { image }) => sum + image.depth, 0))
  return maps.map((map) => ({
    ...map,
    array,
    slice: offsets[arrays.indexOf(map.array as Compressed)] + map.slice,
  }))
}

function concatenate(arrays: readonly Compressed[], label: string): Compressed {
  const [first] = arrays
  const other = arrays.find((array) => layoutOf(array) !== layoutOf(first))
  if (other) {
    throw new FurrowError({
      who: WRINKLE_MAPS,
      problem: `${label} with different layouts`,
      value: layoutOf(other),
      limit: layoutOf(first),
      remedy: 'use one size and encoding for all maps of a kind, or run `furrow pack --ktx2`',
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

/** Describes the size, mipmaps and format of an array, for comparisons and errors. The format is the number of a three.js constant. */
function layoutOf({ image, mipmaps, format, colorSpace }: Compressed): string {
  const encoding = `${colorSpace || 'linear'} format ${format}`
  return `${image.width} x ${image.height} with ${mipmaps?.length} levels, ${encoding}`
}

function concatenateBytes(parts: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
  let offset = 0
  for (const part of parts) {
    bytes.set(part, offset)
    offset += part.length
  }
  return bytes
}
