import { BOTH_SIDES } from '../../../drivers/morph/aliases.ts'
import { canonicalTargetName, targetFinder } from '../../../drivers/morph/target-names.ts'
import { hintOfTarget } from '../../shapes/corrections.ts'
import { hintOf } from '../../shapes/names/hint.ts'
import type { NameHint } from '../../shapes/names/name-hint.ts'
import type { SkinTarget } from '../../skin/surface.ts'

/**
 * Finds the blendshapes of a rig that correspond to ARKit shapes. If a rig has no such blendshape, a stand-in is used: a different blendshape
 * that moves the same part of the face.
 */

/** Kind of each target; undefined if unknown. */
export type TargetHints = readonly (NameHint | undefined)[]

type Find = (name: string) => number[]

/** ARKit names, without `Left` and `Right`, of the blendshapes whose motion determines the positions of wrinkle lines. */
const SHAPES = [
  'browInnerUp',
  'browOuterUp',
  'browDown',
  'eyeBlink',
  'eyeSquint',
  'cheekSquint',
  'eyeWide',
  'jawOpen',
  'mouthFrown',
  'mouthFunnel',
  'mouthPucker',
  'mouthSmile',
  'mouthStretch',
]

/** Guesses what each target does. Uses the name that the user assigned, the target's name, or the name of the VRM expression that moves it. */
export function hintsOf(targets: readonly Omit<SkinTarget, 'offsets'>[]): TargetHints {
  return targets.map(hintOfTarget)
}

/**
 * Creates a function that finds the targets (blendshapes) for an ARKit name, in the spelling of any rig. If no target matches the name, the
 * function returns stand-ins, which may be emotions that move the whole face.
 *
 * @param targets names of the skin's targets.
 * @returns a function from a name to indices into `targets`. It returns an empty array if there is not even a stand-in.
 */
export function faceShapeFinder(targets: readonly string[], hints: TargetHints = targets.map(hintOf)): Find {
  const findPart = partShapeFinder(targets, hints)
  const emotions = closest(hints, ({ kind }) => kind === 'emotion')
  return (name) => firstFound(name, [findPart, emotions])
}

/** Creates a function like `faceShapeFinder`, but without emotions, because emotions move more than one part of the face. */
export function partShapeFinder(targets: readonly string[], hints: TargetHints): Find {
  const find = exactFinder(targets, hints)
  const together = ofSides(matching(hints, ({ match }) => match === 'same'))
  const like = closest(hints, ({ kind, match }) => match === 'like' && kind !== 'emotion')
  return (name) => firstFound(name, [find, together, like])
}

/** Creates a function that finds only targets that equal the named shape or a part of this shape. The function returns no stand-ins. */
function exactFinder(targets: readonly string[], hints: TargetHints): Find {
  const find = targetFinder(targets)
  const exact = ofSides((shape) => {
    const same = ranked(hints, shape, ({ match, shapes }) => match === 'same' && shapes.length === 1)
    const least = Math.min(...same.map(({ rank }) => rank))
    return same
      .filter(({ rank }) => rank === least)
      .slice(0, 1)
      .map(({ index }) => index)
  })
  const parts = ofSides(matching(hints, ({ match }) => match === 'part'))
  return (name) => firstFound(name, [find, exact, parts])
}

/**
 * Converts a pose of ARKit shapes to a pose of a rig's blendshapes. Stand-ins replace shapes that the rig does not have.
 *
 * @param pose weights by ARKit names.
 */
export function poseInRigShapes(
  pose: Readonly<Record<string, number>>,
  targets: readonly string[],
  hints: TargetHints,
): Record<string, number> {
  const [find, findOrStandIn] = [exactFinder(targets, hints), faceShapeFinder(targets, hints)]
  const rewritten: Record<string, number> = {}
  for (const [name, weight] of Object.entries(pose)) {
    const shapes =
      find(name).length > 0 ? [name] : findOrStandIn(name).map((i) => canonicalTargetName(targets[i]))
    for (const shape of shapes) rewritten[shape] = Math.max(rewritten[shape] ?? 0, weight)
  }
  return rewritten
}

/** Returns the names of the targets that are used as stand-ins for missing ARKit shapes. */
export function standInsOf(targets: readonly string[], hints: TargetHints): string[] {
  const [find, findOrStandIn] = [exactFinder(targets, hints), faceShapeFinder(targets, hints)]
  const missing = SHAPES.flatMap(sidesOf).filter((shape) => find(shape).length === 0)
  const found = [...new Set(missing.flatMap(findOrStandIn))]
  return found.filter((index) => hints[index]?.match === 'like').map((index) => targets[index])
}

/** Returns the ARKit names of both sides for a name without a side. If ARKit does not split the shape, returns the name itself. */
function sidesOf(shape: string): string[] {
  return BOTH_SIDES.includes(shape) ? [`${shape}Left`, `${shape}Right`] : [shape]
}

/** Extends a search for ARKit shapes to names without a side. For such a name, the search returns the targets of both sides. */
function ofSides(find: (shape: string) => number[]): Find {
  return (name) => [...new Set(sidesOf(canonicalTargetName(name)).flatMap(find))]
}

function firstFound(name: string, finders: readonly Find[]): number[] {
  for (const find of finders) {
    const found = find(name)
    if (found.length > 0) return found
  }
  return []
}

/** Creates a function that returns all targets whose hint names the shape and passes `isWanted`. */
function matching(hints: TargetHints, isWanted: (hint: NameHint) => boolean): (shape: string) => number[] {
  return (shape) => ranked(hints, shape, isWanted).map(({ index }) => index)
}

/**
 * Creates a function that returns the targets most similar to a shape, among the targets whose hint passes `isWanted`. Targets that move one
 * side take precedence over targets that move both sides.
 */
function closest(hints: TargetHints, isWanted: (hint: NameHint) => boolean): Find {
  return ofSides((shape) => {
    const all = ranked(hints, shape, isWanted)
    const sided = all.filter(({ side }) => side !== undefined)
    const candidates = sided.length > 0 ? sided : all
    const least = Math.min(...candidates.map(({ rank }) => rank))
    return candidates.filter(({ rank }) => rank === least).map(({ index }) => index)
  })
}

function ranked(hints: TargetHints, shape: string, isWanted: (hint: NameHint) => boolean) {
  return hints.flatMap((hint, index) =>
    hint?.shapes.includes(shape) && isWanted(hint) ? [{ index, rank: hint.rank, side: hint.side }] : [],
  )
}
