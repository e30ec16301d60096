import { FurrowError } from '../../core/error.ts'
import { boundingBoxSize } from '../../math/bounds.ts'
import { uvArea } from '../../math/triangle.ts'
import { crossOf, type Skin, type SkinTarget } from './surface.ts'

const WHO = 'autoWrinkles'

/** Way in sizes of the skin beyond which a target is taken for broken. */
const FARTHEST = 2
/** Largest skin that `autoWrinkles` works on. */
export const MOST_TRIANGLES = 2_000_000

/**
 * Checks a skin, and leaves out targets that move nothing or cannot be right.
 *
 * @throws FurrowError for what no wrinkles can be made from.
 */
export function checkSkin(skin: Skin): { skin: Skin; warnings: string[] } {
  const { positions, uvs, indices, targets } = skin
  const vertices = positions.length / 3
  if (targets.length === 0) {
    fail('no blendshapes', undefined, 'targets that move the skin', 'export the face with its blendshapes')
  }
  if (indices.length > 3 * MOST_TRIANGLES) {
    const limit = `${MOST_TRIANGLES.toLocaleString('en')} triangles`
    fail('too many triangles', indices.length / 3, limit, 'decimate the mesh; the maps hold the detail')
  }
  if (uvs.length !== 2 * vertices || indices.length < 3) {
    fail(
      'no triangles with texture coordinates',
      `${indices.length / 3} triangles`,
      undefined,
      'unwrap the mesh',
    )
  }
  if (!allFinite(positions))
    fail('a position is no number', 'NaN', 'finite numbers', 'check how the mesh was exported')
  if (!allFinite(uvs))
    fail('a texture coordinate is no number', 'NaN', 'finite numbers', 'check how the mesh was exported')
  if (!allVertices(indices, vertices)) {
    fail(
      'a triangle has a corner that is no vertex',
      undefined,
      `0..${vertices - 1}`,
      'export the mesh again',
    )
  }
  if (spanOf(uvs, indices) === 0) {
    fail('the texture coordinates span no surface', undefined, 'an unwrapped skin', 'unwrap the mesh')
  }
  if (!hasSurface(positions, indices))
    fail('the mesh has no surface', undefined, 'triangles with area', 'check how the mesh was exported')
  const size = Math.max(...boundingBoxSize(positions))
  const warnings: string[] = []
  const kept = targets.filter((target) => {
    const problem = problemOf(target, size)
    if (problem) warnings.push(`blendshape "${target.name}" ${problem}; it is left out`)
    return !problem
  })
  const moving = kept.filter(({ offsets }) => farthest(offsets) > 0)
  if (moving.length === 0) {
    fail('no blendshape moves the mesh', targets.length, 'targets that move the skin', 'choose another mesh')
  }
  return { skin: { ...skin, targets: kept }, warnings }
}

function fail(what: string, value: unknown, limit: string | undefined, remedy: string): never {
  throw new FurrowError({ who: WHO, what, value, limit, remedy })
}

function problemOf({ offsets }: SkinTarget, size: number): string | undefined {
  if (!allFinite(offsets)) return 'moves something to no place (NaN)'
  return farthest(offsets) > FARTHEST * size ? 'moves farther than the face is large' : undefined
}

function allFinite(values: ArrayLike<number>): boolean {
  for (let i = 0; i < values.length; i++) if (!Number.isFinite(values[i]!)) return false
  return true
}

function allVertices(indices: ArrayLike<number>, vertices: number): boolean {
  for (let i = 0; i < indices.length; i++) if (!(indices[i]! >= 0 && indices[i]! < vertices)) return false
  return true
}

function farthest(offsets: ArrayLike<number>): number {
  let most = 0
  for (let i = 0; i < offsets.length; i++) most = Math.max(most, Math.abs(offsets[i]!))
  return most
}

function hasSurface(positions: ArrayLike<number>, indices: ArrayLike<number>): boolean {
  const normal = new Float64Array(3)
  for (let t = 0; t + 2 < indices.length; t += 3) {
    if (crossOf(positions, indices[t]!, indices[t + 1]!, indices[t + 2]!, normal) > 0) return true
  }
  return false
}

/** Surface of all triangles in the texture. */
function spanOf(uvs: ArrayLike<number>, indices: ArrayLike<number>): number {
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3)
    sum += uvArea(uvs, indices[t]!, indices[t + 1]!, indices[t + 2]!)
  return sum
}
