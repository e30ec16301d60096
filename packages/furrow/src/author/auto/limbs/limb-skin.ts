import { length } from '../../../math/vector.ts'
import { add, scale, subtract, unit, type Vector } from '../../../math/vector3.ts'
import type { SkinSkeleton } from '../../skin/skeleton.ts'
import { placeOf } from '../skeleton/hierarchy.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'

/** Skin that joints move. Positions are in the coordinates of the surface, in millimetres. */
export interface LimbSkin {
  prepared: PreparedSkin
  skeleton: SkinSkeleton
  /** Position of each joint in the bind pose. */
  places: readonly Vector[]
  /** Unit vectors along the x, y and z axes of each joint in the bind pose. */
  axes: readonly (readonly [x: Vector, y: Vector, z: Vector])[]
  /** Unit vector to the person's left. */
  left: Vector
}

/** Creates a `LimbSkin`. Returns undefined if no joints move the skin. */
export function limbSkin(prepared: PreparedSkin): LimbSkin | undefined {
  const { skeleton } = prepared.skin
  if (!skeleton || skeleton.joints.length === 0) return undefined
  const m = prepared.toSurface
  const turn = ([x, y, z]: readonly number[]): Vector => [
    m[0] * x + m[4] * y + m[8] * z,
    m[1] * x + m[5] * y + m[9] * z,
    m[2] * x + m[6] * y + m[10] * z,
  ]
  const places = skeleton.joints.map((joint): Vector => add(turn(placeOf(joint)), [m[12], m[13], m[14]]))
  const axes = skeleton.joints.map(({ bind }) => {
    const column = (k: number) => unit(turn([bind[4 * k], bind[4 * k + 1], bind[4 * k + 2]]))
    return [column(0), column(1), column(2)] as const
  })
  return { prepared, skeleton, places, axes, left: leftOf(skeleton, places) }
}

/** Returns the direction from the joints that are named right to those that are named left. Default: +X, as glTF's models face +Z. */
function leftOf({ joints }: SkinSkeleton, places: readonly Vector[]): Vector {
  const means = [/(^|[^a-z])(l|left)([^a-z]|$)|left/i, /(^|[^a-z])(r|right)([^a-z]|$)|right/i].map((side) => {
    const found = places.filter((_, i) => side.test(joints[i].humanBone ?? joints[i].name))
    return found.length === 0 ? undefined : scale(found.reduce(add, [0, 0, 0]), 1 / found.length)
  })
  const [left, right] = means
  if (!left || !right) return [1, 0, 0]
  const across = subtract(left, right)
  return length(across) > 0 ? unit(across) : [1, 0, 0]
}

/** Returns, for each point of the surface, the total weight of the joints for which `isCounted` is true, 0..1. */
export function pointWeights(
  { prepared: { surface }, skeleton: { influences, indices, weights } }: LimbSkin,
  isCounted: readonly boolean[],
): Float64Array {
  const out = new Float64Array(surface.areas.length)
  for (const [vertex, point] of surface.pointOf.entries()) {
    let counted = 0
    let total = 0
    for (let i = influences * vertex; i < influences * (vertex + 1); i++) {
      total += weights[i]
      if (isCounted[indices[i]]) counted += weights[i]
    }
    out[point] = total > 0 ? counted / total : 0
  }
  return out
}
