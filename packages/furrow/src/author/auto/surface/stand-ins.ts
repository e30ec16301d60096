import { BOTH_SIDES } from '../../../drivers/morph/aliases.ts'
import { canonicalTargetName, targetFinder } from '../../../drivers/morph/target-names.ts'
import { hintOfTarget } from '../../shapes/corrections.ts'
import { hintOf } from '../../shapes/names/hint.ts'
import type { NameHint } from '../../shapes/names/name-hint.ts'
import type { SkinTarget } from '../../skin/surface.ts'

/** Kind of each target, by its index; undefined where nothing tells. */
export type TargetHints = readonly (NameHint | undefined)[]

/** Maps a shape's name to indices of targets. */
type Find = (name: string) => number[]

/** Shapes that the lines of a face rely on, without sides. */
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

/** Tells what targets are by their corrections and names, or else by those of the expressions that move them. */
export function hintsOf(targets: readonly Omit<SkinTarget, 'offsets'>[]): TargetHints {
  return targets.map(hintOfTarget)
}

/**
 * Finds a face's shapes by ARKit's names, as `targetFinder` does, and in the spelling of any rig; where the rig lacks one, its stand-ins:
 * other shapes of that part of the face, or emotions, which move all of it.
 *
 * @param targets the skin's names.
 * @returns maps a name to indices into `targets`, none where there is no stand-in either.
 */
export function faceShapeFinder(targets: readonly string[], hints: TargetHints = targets.map(hintOf)): Find {
  const findPart = partShapeFinder(targets, hints)
  const emotions = closest(hints, ({ kind }) => kind === 'emotion')
  return (name) => firstFound(name, [findPart, emotions])
}

/** The same without emotions: what these move says nothing about where a part of the face is. */
export function partShapeFinder(targets: readonly string[], hints: TargetHints): Find {
  const find = exactFinder(targets, hints)
  const together = ofSides(matching(hints, ({ match }) => match === 'same'))
  const like = closest(hints, ({ kind, match }) => match === 'like' && kind !== 'emotion')
  return (name) => firstFound(name, [find, together, like])
}

/** The same without stand-ins and shapes that are several of ARKit's at once. */
function exactFinder(targets: readonly string[], hints: TargetHints): Find {
  const find = targetFinder(targets)
  const whole = ofSides((shape) => {
    const same = ranked(hints, shape, ({ match, shapes }) => match === 'same' && shapes.length === 1)
    const least = Math.min(...same.map(({ rank }) => rank))
    return same
      .filter(({ rank }) => rank === least)
      .slice(0, 1)
      .map(({ index }) => index)
  })
  const parts = ofSides(matching(hints, ({ match }) => match === 'part'))
  return (name) => firstFound(name, [find, whole, parts])
}

/**
 * Rewrites a pose in the shapes that the rig has: a missing shape is replaced by its stand-ins.
 *
 * @param pose weights by ARKit's names.
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

/** Names of the targets that stand in for shapes which the rig lacks. */
export function standInsOf(targets: readonly string[], hints: TargetHints): string[] {
  const [find, findOrStandIn] = [exactFinder(targets, hints), faceShapeFinder(targets, hints)]
  const missing = SHAPES.flatMap(sidesOf).filter((shape) => find(shape).length === 0)
  const found = [...new Set(missing.flatMap(findOrStandIn))]
  return found.filter((index) => hints[index]?.match === 'like').map((index) => targets[index])
}

/** ARKit's names of a shape that has no side in its name. */
function sidesOf(shape: string): string[] {
  return BOTH_SIDES.includes(shape) ? [`${shape}Left`, `${shape}Right`] : [shape]
}

/** A name without a side means the shapes of both sides. */
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

/** All targets of a kind that have the shape. */
function matching(hints: TargetHints, isWanted: (hint: NameHint) => boolean): (shape: string) => number[] {
  return (shape) => ranked(hints, shape, isWanted).map(({ index }) => index)
}

/** Finds targets of a kind that resemble a shape most. Targets of its side alone come before both-sided ones. */
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
