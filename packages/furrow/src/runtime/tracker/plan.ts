import { mirroredName } from '../../drivers/morph/mirrored-name.ts'
import type { BindTargets, TargetBinding } from '../target-binding.ts'
import { mixOf, shapesOfScore } from './source-names.ts'
import { SUBSTITUTES } from './substitutes.ts'

/** Contribution of a score to a blendshape. */
export interface ScoreLink {
  /** Index of the score. */
  score: number
  /** Index of the shape. */
  shape: number
  /** Factors for positive and for negative scores. */
  up: number
  down: number
}

/** A substitute for the shapes of a plan. */
export interface SubstituteLink {
  /** Raises the weight of its shape. `reach` are the highest weights that the source delivered so far. */
  apply(weights: Float64Array, reach: Float64Array): void
}

/** Connection of a list of score names to the blendshapes of a face. */
export interface TrackerPlan {
  /** Canonical names of the shapes. */
  shapes: readonly string[]
  links: readonly ScoreLink[]
  substitutes: readonly SubstituteLink[]
  /** Targets of the face. The field `name` is an index into `shapes`. */
  bindings: readonly TargetBinding[]
  /** Names of scores that have no effect on this face. */
  missing: readonly string[]
}

/**
 * Connects scores to the blendshapes of a face. A score whose shape the face lacks moves the shapes of its mix instead.
 *
 * @param names names of the scores.
 * @param isMirrored whether left scores move the right side of the face.
 */
export function planTracker(
  names: readonly string[],
  bind: BindTargets,
  { isMirrored, hasSubstitutes }: { isMirrored: boolean; hasSubstitutes: boolean },
): TrackerPlan {
  const candidates = names.map(shapesOfScore)
  const known = [
    ...new Set([
      ...candidates.flat().flatMap((name) => [name, ...partsOf(name)]),
      ...(hasSubstitutes ? SUBSTITUTES.map(({ shape }) => shape) : []),
    ]),
  ]
  const found = bind(isMirrored ? known.map(mirroredName) : known)
  const bound = new Set(found.map(({ name }) => known[name]))

  const shapes: string[] = []
  const indexOf = (shape: string) => {
    const index = shapes.indexOf(shape)
    return index >= 0 ? index : shapes.push(shape) - 1
  }
  const links: ScoreLink[] = []
  const missing: string[] = []
  for (const [score, possible] of candidates.entries()) {
    const name = possible.find((each) => bound.has(each)) ?? possible.at(-1)
    if (name === undefined) continue
    const mix = mixOf(name)
    const parts = partsOf(name)
    if (bound.has(name) || (hasSubstitutes && isSubstituted(name)))
      links.push({ score, shape: indexOf(name), up: 1, down: 0 })
    else if (mix && (parts.length === 0 || parts.some((part) => bound.has(part)))) {
      for (const [part, up] of Object.entries(mix.up))
        links.push({ score, shape: indexOf(part), up, down: 0 })
      for (const [part, down] of Object.entries(mix.down ?? {})) {
        links.push({ score, shape: indexOf(part), up: 0, down })
      }
    } else missing.push(names[score])
  }
  const substitutes = SUBSTITUTES.filter(
    ({ from }) => hasSubstitutes && from.every((name) => shapes.includes(name)),
  ).map(({ shape, from: [a, b], create }) => ({ apply: create(indexOf(shape), indexOf(a), indexOf(b)) }))
  const bindings = found
    .filter(({ name }) => shapes.includes(known[name]))
    .map((binding) => ({ ...binding, name: indexOf(known[binding.name]) }))
  return { shapes, links, substitutes, bindings, missing }
}

function partsOf(name: string): string[] {
  const mix = mixOf(name)
  return mix ? [...Object.keys(mix.up), ...Object.keys(mix.down ?? {})] : []
}

/** Whether a substitute reads the shape. */
function isSubstituted(name: string): boolean {
  return SUBSTITUTES.some(({ from }) => from.includes(name))
}
