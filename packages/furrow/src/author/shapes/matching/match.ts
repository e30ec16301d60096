import { log } from '../../../math/elementary.ts'
import type { SkinTarget } from '../../skin/surface.ts'
import { arkitName, isCentral, isShifted, type ShapeLabel, type Side } from '../families.ts'
import {
  type Descriptor,
  descriptorOf,
  dotAll,
  halfField,
  leftFraction,
  likeness,
  sumOf,
} from '../fields/field-operations.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import { type TemplateHead, templatesOf } from '../templates/templates.ts'
import { assign } from './assign.ts'
import { physicalScore } from './physical-tests.ts'

/** ARKit label that fits a shape best. A shape is a blendshape of the user's face. */
export interface Match {
  /** Index in `ShapeFields.shapes`. */
  shape: number
  label: ShapeLabel
  /** Similarity of the shape to the label's templates (motions of reference heads), at most about 1. Closed lids raise a blink's score. */
  score: number
  /** Difference between the scores of the label and the next best label. It is smaller if another shape fits the label almost as well. */
  margin: number
  /**
   * Cosine between the shape's motion and the motion that other shapes predict for the label. For example, the left and the right smile
   * predict the smile on both sides. Without a prediction, this is the cosine to the motion of the label's owner (see `matchShapes`), or 0 if
   * there is no owner. For the owner itself, this is the minimum cosine to its rivals for the label, or 1 if it has no rivals.
   */
  kinship: number
}

/** Motion and score of the shape to which a label is assigned. */
interface LabelOwner {
  field: Float64Array
  score: number
}

/** A shape gets a label only if its strength (see `ShapeField`) exceeds this. */
const WEAK = 0.01
/** Minimum cosine between the motions of two shapes that differ only in strength. */
export const SAME = 0.975
/** Maximum cosine between two motions that count as different. */
export const MAX_DIFFERENT = 0.9
/** A shape's rival for a label scores at most this much less than the shape. */
const RIVAL = 0.11
/** Minimum score of a shape for a label that it may own. Each label has at most one owner, see `matchShapes`. */
const MIN_SCORE = 0.3
/** A label counts as found if a shape has at least this score for it. */
export const FOUND = 0.45
/** Penalty if shape and template differ in strength: factor on the absolute natural logarithm of the ratio of their strengths. */
const STRENGTH = 0.04
/** Two labels whose templates are at most this similar are distinct: the difference of their scores counts fully in a margin. */
const DISTINCT = 0.5

export interface Scores {
  labels: readonly ShapeLabel[]
  /** For each shape, its score for each label. */
  scores: readonly Float64Array[]
  /** Descriptors of the templates of each label. */
  templates: readonly (readonly Descriptor[])[]
}

/** Scores shapes by their similarity to the templates of several heads. */
export function scoresOf(fields: ShapeFields, heads: readonly TemplateHead[]): Scores {
  const labels: ShapeLabel[] = []
  const indexOf = new Map<string, number>()
  /** Similarity of each shape to each head's template. Indices: label, shape, head. */
  const found: number[][][] = []
  const templates: Descriptor[][] = []
  for (const head of heads) {
    const weights = fields.weights.map((weight, i) => weight * head.weights[i])
    const descriptors = fields.shapes.map(({ field }) => descriptorOf(field, weights))
    for (const { family, side, field, strength } of templatesOf(head)) {
      const name = arkitName({ family, side })
      const label = indexOf.get(name) ?? labels.length
      if (label === labels.length) {
        indexOf.set(name, label)
        labels.push({ family, side })
        found.push(fields.shapes.map(() => []))
        templates.push([])
      }
      const template = descriptorOf(field, weights)
      templates[label].push(template)
      const list = found[label]
      for (const [i, shape] of fields.shapes.entries()) {
        const ratio = Math.abs(log(Math.max(shape.strength, 1e-4) / Math.max(strength, 1e-4)))
        list[i].push(likeness(descriptors[i], template) - STRENGTH * ratio)
      }
    }
  }
  const scores = fields.shapes.map((shape, i) => {
    const left = leftFraction(shape.field, fields.weights)
    return Float64Array.from(
      labels,
      (label, j) => bestTwo(found[j][i]) + sideScore(label, left) + physicalScore(label, shape),
    )
  })
  return { labels, scores, templates }
}

/** Replaces the scores of shapes whose ARKit name the user assigned, so that these shapes get their labels before all other shapes. */
export function correctScores(
  { labels, scores, templates }: Scores,
  { shapes }: ShapeFields,
  targets: readonly SkinTarget[],
): Scores {
  const corrected = scores.map((row, i) => {
    const { correction } = targets[shapes[i].target]
    if (typeof correction !== 'string') return row
    return Float64Array.from(labels, (label) => (arkitName(label) === correction ? 2 : -1))
  })
  return { labels, scores: corrected, templates }
}

function bestTwo(values: readonly number[]): number {
  const [first, second = first] = [...values].sort((a, b) => b - a)
  return 0.6 * first + 0.4 * second
}

/** Returns a penalty, at most 0, for motion on the wrong side of the face. `left` is the fraction of the motion on the left. */
function sideScore({ family, side }: ShapeLabel, left: number): number {
  if (side === 'left') return -0.5 * Math.max(0.7 - left, 0)
  if (side === 'right') return -0.5 * Math.max(left - 0.3, 0)
  return isShifted(family) ? 0 : -Math.max(Math.abs(left - 0.5) - 0.2, 0)
}

/**
 * Assigns labels to shapes. First, each label is assigned to at most one shape, its owner, so that the total score is highest. Then each
 * remaining shape gets the label that fits it best, even if the label has an owner.
 *
 * @param composites indices of shapes that get no label.
 */
export function matchShapes(
  fields: ShapeFields,
  { labels, scores, templates }: Scores,
  composites: ReadonlySet<number> = new Set(),
): Match[] {
  const { shapes, weights } = fields
  const descriptors = shapes.map(({ field }) => descriptorOf(field, weights))
  const leaders = leadersOf(fields, descriptors, composites)
  const live = leaders.flatMap((leader, i) =>
    leader === i && !composites.has(i) && shapes[i].strength > WEAK ? [i] : [],
  )
  if (live.length === 0) return []
  const cost = live.map((i) => {
    const row = new Float64Array(labels.length + live.length).fill(1 - MIN_SCORE)
    for (let j = 0; j < labels.length; j++) row[j] = 1 - scores[i][j]
    return row
  })
  const columns = assign(cost)
  const owners = new Map(live.map((shape, n) => [columns[n], shape]))
  /**
   * Factor on the difference between a shape's scores for two labels, if the second label has no owner. The factor is small if the templates
   * of two families are alike, because the scores for such labels are close for every shape.
   */
  const dissimilarity = (j: number, k: number) =>
    labels[j].family === labels[k].family || isOpposite(labels[j], labels[k])
      ? 1
      : Math.min(1, (1 - maxLikeness(templates[j], templates[k])) / (1 - DISTINCT))
  const chosen = new Map<number, { label: number; margin: number }>()
  for (const [n, shape] of live.entries()) {
    const isFirst = columns[n] < labels.length
    const label = isFirst ? columns[n] : bestOf(scores[shape])
    let margin = 1
    for (let k = 0; k < labels.length; k++) {
      if (k === label) continue
      const owner = owners.get(k)
      const gap = scores[shape][label] - scores[shape][k]
      const isTaken = owner !== undefined && scores[owner][k] > FOUND
      const loss =
        isFirst && owner !== undefined ? scores[owner][k] - Math.max(scores[owner][label], MIN_SCORE) : 0
      margin = Math.min(margin, (isTaken || gap < 0 ? gap : gap * dissimilarity(label, k)) + loss)
    }
    chosen.set(shape, { label, margin })
  }
  const owned = new Map(
    [...owners].flatMap(([j, shape]) =>
      j < labels.length
        ? [[arkitName(labels[j]), { field: shapes[shape].field, score: scores[shape][j] }] as const]
        : [],
    ),
  )
  const kinships = leaders.map((leader, shape) => {
    const label = chosen.get(leader)?.label ?? -1
    if (label < 0) return 1
    const owner = owners.get(label)
    const known = otherSides(labels[label], owned) ?? (owner === undefined ? undefined : shapes[owner].field)
    if (known === shapes[shape].field) return 1
    return known ? dotAll(descriptors[shape].plain, descriptorOf(known, weights).plain) : 0
  })
  const spare = live.filter((shape) => kinships[shape] < MAX_DIFFERENT)
  /** Returns the minimum cosine between a shape and its rivals. Rivals are shapes in `spare` that fit the same label best. */
  const agreement = (shape: number, label: number) => {
    const least = Math.max(FOUND, scores[shape][label] - RIVAL)
    const rivals = spare.filter((other) => bestOf(scores[other]) === label && scores[other][label] > least)
    return Math.min(1, ...rivals.map((other) => dotAll(descriptors[shape].plain, descriptors[other].plain)))
  }
  return leaders.flatMap((leader, shape) => {
    const found = chosen.get(leader)
    if (!found) return []
    const { label, margin } = found
    const kinship = kinships[shape]
    const weaker = STRENGTH * log(shapes[leader].strength / shapes[shape].strength)
    return [
      {
        shape,
        label: labels[label],
        score: scores[leader][label] - weaker,
        margin,
        kinship: kinship < 1 ? kinship : agreement(shape, label),
      },
    ]
  })
}

/**
 * Predicts the motion of a shape with the given label from shapes of the same family for other sides. For both sides, the prediction is the
 * sum of the left and the right shape. For one side of a family in `CENTRAL`, the prediction is this side's half of the shape for both sides.
 * The shape for both sides is used only if its score is higher than the score of the label's owner.
 */
function otherSides(
  { family, side }: ShapeLabel,
  owned: ReadonlyMap<string, LabelOwner>,
): Float64Array | undefined {
  const owner = (other: Side, least: number) => {
    const found = owned.get(arkitName({ family, side: other }))
    return found && found.score > least ? found.field : undefined
  }
  if (side === 'both') {
    const [left, right] = [owner('left', FOUND), owner('right', FOUND)]
    return left && right && sumOf(left, right)
  }
  const least = owned.get(arkitName({ family, side }))?.score ?? 0
  const both = isCentral(family) ? owner('both', least) : undefined
  return both && halfField(both, side)
}

function isOpposite({ side }: ShapeLabel, other: ShapeLabel): boolean {
  return side !== other.side && side !== 'both' && other.side !== 'both'
}

function maxLikeness(a: readonly Descriptor[], b: readonly Descriptor[]): number {
  return Math.max(...a.flatMap((one) => b.map((other) => likeness(one, other))))
}

function bestOf(scores: Float64Array): number {
  return scores.reduce((best, score, j) => (score > scores[best] ? j : best), 0)
}

/** Returns, for each shape, the index of the strongest shape with the same motion, which may be the shape itself. */
function leadersOf(
  { shapes }: ShapeFields,
  descriptors: readonly Descriptor[],
  composites: ReadonlySet<number>,
): number[] {
  const leaders = shapes.map((_, i) => i)
  const order = leaders
    .filter((i) => !composites.has(i))
    .sort((a, b) => shapes[b].strength - shapes[a].strength || a - b)
  for (const [k, i] of order.entries()) {
    if (shapes[i].strength <= WEAK) continue
    const leader = order
      .slice(0, k)
      .find((j) => leaders[j] === j && dotAll(descriptors[i].plain, descriptors[j].plain) > SAME)
    if (leader !== undefined) leaders[i] = leader
  }
  return leaders
}
