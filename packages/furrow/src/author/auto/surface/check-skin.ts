import { FurrowError } from '../../../core/error.ts'
import { boundingBoxSize } from '../../../math/bounds.ts'
import { uvArea } from '../../../math/triangle.ts'
import { labelOf } from '../../shapes/families.ts'
import { type Skin, type SkinTarget, surfaceArea } from '../../skin/surface.ts'

/** Maximum displacement of a vertex, as a multiple of the skin's extent. Targets with larger displacements are broken and dropped. */
const MAX_OFFSET = 2
/** Maximum extent of a skin, as a multiple of the square root of its area. Hair made of thin strips reaches about 50. */
const MAX_EXTENT = 1000
export const MAX_SKIN_TRIANGLES = 2_000_000

const CHECK_EXPORT = 'check how the mesh was exported'

/**
 * Checks a skin and drops broken targets (blendshapes).
 *
 * @throws FurrowError if no wrinkles can be made for the skin.
 */
export function checkSkin(skin: Skin): { skin: Skin; warnings: string[] } {
  const { positions, uvs, indices, targets } = skin
  const vertices = positions.length / 3
  const triangles = indices.length / 3
  if (targets.length === 0 && !skin.skeleton) {
    const remedy = 'export the face with its blendshapes, or the body with its skeleton'
    fail('no blendshapes and no skeleton', undefined, 'targets or joints that move the skin', remedy)
  }
  if (triangles > MAX_SKIN_TRIANGLES) {
    const limit = `${MAX_SKIN_TRIANGLES.toLocaleString('en')} triangles`
    fail('too many triangles', triangles, limit, 'decimate the mesh; the maps hold the detail')
  }
  if (uvs.length !== 2 * vertices || indices.length < 3) {
    fail('no triangles with texture coordinates', `${triangles} triangles`, undefined, 'unwrap the mesh')
  }
  if (!allFinite(positions)) fail('a position is NaN or infinite', 'NaN', 'finite numbers', CHECK_EXPORT)
  if (!allFinite(uvs)) fail('a texture coordinate is NaN or infinite', 'NaN', 'finite numbers', CHECK_EXPORT)
  if (!allVertices(indices, vertices)) {
    const limit = `0..${vertices - 1}`
    fail('a triangle has an index out of range', undefined, limit, 'export the mesh again')
  }
  if (totalUvArea(uvs, indices) === 0) {
    fail('the texture coordinates span no area', undefined, 'an unwrapped skin', 'unwrap the mesh')
  }
  const area = surfaceArea(positions, indices)
  if (!(area > 0)) fail('the mesh has no area', undefined, 'triangles with area', CHECK_EXPORT)
  const size = Math.max(...boundingBoxSize(usedPositions(positions, indices)))
  if (!(size <= MAX_EXTENT * Math.sqrt(area))) {
    const limit = `${MAX_EXTENT} times the side of a square of its area`
    fail('the mesh is too large for its area', size, limit, CHECK_EXPORT)
  }
  const wrong = targets.find(({ correction }) => typeof correction === 'string' && !labelOf(correction))
  if (wrong) {
    const limit = "ARKit's names, with or without a side, or null"
    fail(`the correction of blendshape "${wrong.name}" is unknown`, wrong.correction, limit, 'correct it')
  }
  const warnings: string[] = []
  const usable = targets.filter((target) => {
    const problem = problemOf(target, size)
    if (problem) warnings.push(`blendshape "${target.name}" ${problem}; it is skipped`)
    return !problem
  })
  if (!skin.skeleton && !usable.some(({ offsets }) => largestOffset(offsets) > 0)) {
    fail('no blendshape moves the mesh', targets.length, 'targets that move the skin', 'choose another mesh')
  }
  return { skin: usable.length < targets.length ? { ...skin, targets: usable } : skin, warnings }
}

function fail(problem: string, value: unknown, limit: string | undefined, remedy: string): never {
  throw new FurrowError({ who: 'autoWrinkles', problem, value, limit, remedy })
}

function problemOf({ offsets }: SkinTarget, size: number): string | undefined {
  if (!allFinite(offsets)) return 'has offsets that are NaN or infinite'
  return largestOffset(offsets) > MAX_OFFSET * size
    ? `moves vertices farther than ${MAX_OFFSET} times the size of the face`
    : undefined
}

function allFinite(values: ArrayLike<number>): boolean {
  for (let i = 0; i < values.length; i++) if (!Number.isFinite(values[i])) return false
  return true
}

function allVertices(indices: ArrayLike<number>, vertices: number): boolean {
  for (let i = 0; i < indices.length; i++) if (!(indices[i] >= 0 && indices[i] < vertices)) return false
  return true
}

function largestOffset(offsets: ArrayLike<number>): number {
  let largest = 0
  for (let i = 0; i < offsets.length; i++) largest = Math.max(largest, Math.abs(offsets[i]))
  return largest
}

/** Returns the position of each corner of each triangle. */
function usedPositions(positions: ArrayLike<number>, indices: ArrayLike<number>): Float64Array {
  const used = new Float64Array(3 * indices.length)
  for (let i = 0; i < indices.length; i++) {
    for (let k = 0; k < 3; k++) used[3 * i + k] = positions[3 * indices[i] + k]
  }
  return used
}

function totalUvArea(uvs: ArrayLike<number>, indices: ArrayLike<number>): number {
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3)
    sum += uvArea(uvs, indices[t], indices[t + 1], indices[t + 2])
  return sum
}
