import type { SkinTarget } from '../skin/surface.ts'
import { assign } from './assign.ts'
import { arkitName, isShifted, type ShapeLabel } from './families.ts'
import { type Descriptor, descriptorOf, dotAll, leftFraction, likeness } from './field-operations.ts'
import { physicalScore } from './physical-tests.ts'
import type { ShapeFields } from './shape-fields.ts'
import { type TemplateHead, templatesOf } from './templates.ts'

/** The label that a shape is most like. */
export interface Match {
  /** Index into the shapes. */
  shape: number
  label: ShapeLabel
  /** Likeness to the templates, at most 1 and the bonus of lids that meet. */
  score: number
  /** How much worse the second best labels are, for this shape and the one it would swap its label with. */
  margin: number
  /** Whether the label is its own, one per label; otherwise it shares it with a shape that fits better. */
  isFirst: boolean
}

/** Displacement below which a shape is no expression. */
const WEAK = 0.01
/** Cosine from which on two shapes are the same at another strength. */
const SAME = 0.975
/** Score that a shape needs for a label of its own. */
const LEAST_SCORE = 0.3
/** Penalty for another strength, per factor of e. */
const STRENGTH = 0.04

/** Scores of each shape by label. */
export interface Scores {
  labels: readonly ShapeLabel[]
  scores: readonly Float64Array[]
}

/** Compares shapes with the templates of some heads. */
export function scoresOf(fields: ShapeFields, heads: readonly TemplateHead[]): Scores {
  const labels: ShapeLabel[] = []
  const indexOf = new Map<string, number>()
  /** By label, then by shape: the likeness to each head. */
  const found: number[][][] = []
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
      }
      const template = descriptorOf(field, weights)
      const list = found[label]
      for (const [i, shape] of fields.shapes.entries()) {
        const ratio = Math.abs(Math.log(Math.max(shape.strength, 1e-4) / Math.max(strength, 1e-4)))
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
  return { labels, scores }
}

/** Gives corrected shapes their labels before all others. */
export function correctScores(
  { labels, scores }: Scores,
  { shapes }: ShapeFields,
  targets: readonly SkinTarget[],
): Scores {
  const corrected = scores.map((row, i) => {
    const { correction } = targets[shapes[i].target]
    if (typeof correction !== 'string') return row
    return Float64Array.from(labels, (label) => (arkitName(label) === correction ? 2 : -1))
  })
  return { labels, scores: corrected }
}

function bestTwo(values: readonly number[]): number {
  const [first, second = first] = [...values].sort((a, b) => b - a)
  return 0.6 * first + 0.4 * second
}

/** Penalty for motion on the wrong side. */
function sideScore({ family, side }: ShapeLabel, left: number): number {
  if (side === 'left') return -0.5 * Math.max(0.7 - left, 0)
  if (side === 'right') return -0.5 * Math.max(left - 0.3, 0)
  return isShifted(family) ? 0 : -Math.max(Math.abs(left - 0.5) - 0.2, 0)
}

/** Labels shapes: one shape per label first, then shapes that are left over and fit a label well. */
export function matchShapes(fields: ShapeFields, { labels, scores }: Scores): Match[] {
  const leaders = leadersOf(fields)
  const live = leaders.flatMap((leader, i) => (leader === i && fields.shapes[i].strength > WEAK ? [i] : []))
  if (live.length === 0) return []
  const cost = live.map((i) => {
    const row = new Float64Array(labels.length + live.length).fill(1 - LEAST_SCORE)
    for (let j = 0; j < labels.length; j++) row[j] = 1 - scores[i][j]
    return row
  })
  const columns = assign(cost)
  /** Shape that has each label. */
  const owners = new Map(live.map((shape, n) => [columns[n], shape]))
  const own = new Map<number, Match>()
  for (const [n, shape] of live.entries()) {
    const isFirst = columns[n] < labels.length
    const j = isFirst ? columns[n] : bestOf(scores[shape])
    const score = scores[shape][j]
    let margin = 1
    for (let k = 0; k < labels.length; k++) {
      const owner = isFirst ? owners.get(k) : undefined
      const loss = owner === undefined ? 0 : scores[owner][k] - Math.max(scores[owner][j], LEAST_SCORE)
      if (k !== j) margin = Math.min(margin, score - scores[shape][k] + loss)
    }
    own.set(shape, { shape, label: labels[j], score, margin, isFirst })
  }
  return leaders.flatMap((leader, shape) => {
    const match = own.get(leader)
    return match ? [{ ...match, shape, isFirst: match.isFirst && leader === shape }] : []
  })
}

function bestOf(scores: Float64Array): number {
  return scores.reduce((best, score, j) => (score > scores[best] ? j : best), 0)
}

/** For each shape the strongest one with the same displacements. */
function leadersOf({ weights, shapes }: ShapeFields): number[] {
  const descriptors: Descriptor[] = shapes.map(({ field }) => descriptorOf(field, weights))
  const leaders = shapes.map((_, i) => i)
  const order = [...leaders].sort((a, b) => shapes[b].strength - shapes[a].strength || a - b)
  for (const [k, i] of order.entries()) {
    if (shapes[i].strength <= WEAK) continue
    const leader = order
      .slice(0, k)
      .find((j) => leaders[j] === j && dotAll(descriptors[i].plain, descriptors[j].plain) > SAME)
    if (leader !== undefined) leaders[i] = leader
  }
  return leaders
}
