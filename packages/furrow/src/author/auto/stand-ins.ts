import { canonicalTargetName, targetFinder } from '../../drivers/morph/target-names.ts'

/**
 * What stands in for a shape that a rig does not have: shapes of a part of the face that move the same skin in the same way, the
 * nearest first. They are not the same shape, so `ALIASES` does not have them. VRoid's are `Fcl_BRW_...` for brows, `Fcl_EYE_...`
 * and `Fcl_MTH_...`, most of them for both sides at once.
 */
const STAND_INS: Readonly<Record<string, readonly string[]>> = {
  browInnerUp: ['Fcl_BRW_Surprised', 'Fcl_BRW_Sorrow', 'Fcl_BRW_Fun'],
  browOuterUp: ['Fcl_BRW_Surprised', 'Fcl_BRW_Fun'],
  browDown: ['Fcl_BRW_Angry'],
  eyeBlinkLeft: ['blinkLeft'],
  eyeBlinkRight: ['blinkRight'],
  eyeSquintLeft: ['Fcl_EYE_Joy_L'],
  eyeSquintRight: ['Fcl_EYE_Joy_R'],
  eyeSquint: ['Fcl_EYE_Joy', 'Fcl_EYE_Fun'],
  cheekSquintLeft: ['Fcl_EYE_Joy_L'],
  cheekSquintRight: ['Fcl_EYE_Joy_R'],
  cheekSquint: ['Fcl_EYE_Joy', 'Fcl_EYE_Fun'],
  eyeWide: ['Fcl_EYE_Spread', 'Fcl_EYE_Surprised'],
  jawOpen: ['viseme_aa'],
  mouthFrown: ['Fcl_MTH_Sorrow', 'Fcl_MTH_Angry', 'Fcl_MTH_Down'],
  mouthFunnel: ['viseme_O'],
  mouthPucker: ['Fcl_MTH_Small', 'viseme_U'],
  mouthSmile: ['Fcl_MTH_Fun', 'Fcl_MTH_Joy', 'Fcl_MTH_Up'],
  mouthStretch: ['Fcl_MTH_Large', 'viseme_I'],
}

/**
 * Finds a face's shapes by ARKit's names, as `targetFinder` does; where the rig does not have one, what stands in for it.
 *
 * @param targets the skin's names.
 * @returns of a name the indices into `targets`; empty where nothing stands in.
 */
export function faceShapeFinder(targets: readonly string[]): (name: string) => number[] {
  const find = targetFinder(targets)
  const nearest = (names: readonly string[] = []) => names.map(find).find((found) => found.length > 0) ?? []
  return (name) => {
    const own = find(name)
    if (own.length > 0) return own
    const shape = canonicalTargetName(name)
    const sided = nearest(STAND_INS[shape])
    return sided.length > 0 ? sided : nearest(STAND_INS[shape.replace(/(Left|Right)$/, '')])
  }
}

/**
 * A pose in the shapes that the rig has: what it lacks is named by what stands in for it, once.
 *
 * @param pose weights by ARKit's names.
 */
export function poseInOwnShapes(
  pose: Readonly<Record<string, number>>,
  targets: readonly string[],
): Record<string, number> {
  const [find, findAny] = [targetFinder(targets), faceShapeFinder(targets)]
  const own: Record<string, number> = {}
  for (const [name, weight] of Object.entries(pose)) {
    const names = find(name).length > 0 ? [name] : findAny(name).map((i) => canonicalTargetName(targets[i]!))
    for (const one of names) own[one] = Math.max(own[one] ?? 0, weight)
  }
  return own
}

/** Names of the targets that stand in for shapes which the rig does not have. */
export function standInsOf(targets: readonly string[]): string[] {
  const [find, findAny] = [targetFinder(targets), faceShapeFinder(targets)]
  const lacking = Object.keys(STAND_INS).filter((shape) => find(shape).length === 0)
  return [...new Set(lacking.flatMap(findAny))].map((index) => targets[index]!)
}
