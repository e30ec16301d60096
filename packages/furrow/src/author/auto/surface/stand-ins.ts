import { canonicalTargetName, targetFinder } from '../../../drivers/morph/target-names.ts'

/**
 * Stand-ins for shapes that a rig lacks: shapes of a part of the face that move the same skin in the same way, the closest first. They are
 * not the same shape, so they are not in `ALIASES`. VRoid's are `Fcl_BRW_...` for brows, `Fcl_EYE_...` and `Fcl_MTH_...`, most of them
 * for both sides at once.
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
 * Emotions, which move the whole face, in place of shapes that a rig has neither itself nor in part: VRM's presets and VRoid's
 * `Fcl_ALL_...`, by their canonical names.
 */
const EMOTIONS: Readonly<Record<string, readonly string[]>> = {
  browInnerUp: ['surprised', 'sad'],
  browOuterUp: ['surprised'],
  browDown: ['angry'],
  eyeSquint: ['happy', 'relaxed'],
  cheekSquint: ['happy', 'relaxed'],
  eyeWide: ['surprised'],
  mouthFrown: ['sad', 'angry'],
  mouthSmile: ['happy', 'relaxed'],
}

/**
 * Finds a face's shapes by ARKit's names, as `targetFinder` does; where the rig lacks one, its stand-ins.
 *
 * @param targets the skin's names.
 * @returns maps a name to indices into `targets`, none where there is no stand-in either.
 */
export function faceShapeFinder(targets: readonly string[]): (name: string) => number[] {
  const [find, findPart] = [targetFinder(targets), partShapeFinder(targets)]
  return (name) => {
    const part = findPart(name)
    if (part.length > 0) return part
    const emotions = EMOTIONS[canonicalTargetName(name).replace(/(Left|Right)$/, '')] ?? []
    return emotions.map(find).find((indices) => indices.length > 0) ?? []
  }
}

/** The same without emotions: what these move says nothing about where a part of the face is. */
export function partShapeFinder(targets: readonly string[]): (name: string) => number[] {
  const find = targetFinder(targets)
  const firstFound = (names: readonly string[] = []) =>
    names.map(find).find((indices) => indices.length > 0) ?? []
  return (name) => {
    const exact = find(name)
    if (exact.length > 0) return exact
    const shape = canonicalTargetName(name)
    const sided = firstFound(STAND_INS[shape])
    return sided.length > 0 ? sided : firstFound(STAND_INS[shape.replace(/(Left|Right)$/, '')])
  }
}

/**
 * Rewrites a pose in the shapes that the rig has: a missing shape is replaced by its stand-ins.
 *
 * @param pose weights by ARKit's names.
 */
export function poseInRigShapes(
  pose: Readonly<Record<string, number>>,
  targets: readonly string[],
): Record<string, number> {
  const [find, findOrStandIn] = [targetFinder(targets), faceShapeFinder(targets)]
  const rewritten: Record<string, number> = {}
  for (const [name, weight] of Object.entries(pose)) {
    const shapes =
      find(name).length > 0 ? [name] : findOrStandIn(name).map((i) => canonicalTargetName(targets[i]))
    for (const shape of shapes) rewritten[shape] = Math.max(rewritten[shape] ?? 0, weight)
  }
  return rewritten
}

/** Names of the targets that stand in for shapes which the rig lacks. */
export function standInsOf(targets: readonly string[]): string[] {
  const [find, findOrStandIn] = [targetFinder(targets), faceShapeFinder(targets)]
  const missing = [...new Set([...Object.keys(STAND_INS), ...Object.keys(EMOTIONS)])].filter(
    (shape) => find(shape).length === 0,
  )
  return [...new Set(missing.flatMap(findOrStandIn))].map((index) => targets[index])
}
