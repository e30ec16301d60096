import type { Skin, SkinTarget } from '../skin/surface.ts'
import { hintOfTarget } from './corrections.ts'
import { arkitName, isCentral, isShifted, labelOf, mirroredLabel, type ShapeLabel } from './families.ts'
import { leftFraction } from './fields/field-operations.ts'
import { type ShapeFields, shapeFields } from './fields/shape-fields.ts'
import { faceFrame } from './landmarks/face-frame.ts'
import { movingSurface } from './landmarks/moving-surface.ts'
import { compositesOf } from './matching/composites.ts'
import { confidencesOf, SURE, UNSURE } from './matching/confidence.ts'
import { correctScores, matchShapes, scoresOf } from './matching/match.ts'
import type { NameHint } from './names/name-hint.ts'
import { templateHeads } from './templates/template-table.ts'
import type { TemplateHead } from './templates/templates.ts'
import type { Vector } from './vectors.ts'

/** Result of the recognition of one blendshape. */
export interface RecognisedShape {
  name: string
  /**
   * ARKit name, without `Left` or `Right` if the blendshape moves both sides. Undefined if the blendshape is unknown, or does not correspond
   * to a single ARKit shape.
   */
  shape: string | undefined
  /** Confidence, 0..1. */
  confidence: number
  /** Evidence for `shape`: the motion, the name, both of them, or a correction by the user. A correction has the confidence 1. */
  by: 'geometry' | 'name' | 'both' | 'correction' | 'none'
  /** Meaning of the blendshape's name, or of the ARKit name in `shape` if the motion decided. */
  hint: NameHint | undefined
  /** Whether the motion contradicts the name. */
  isMisnamed: boolean
}

/** ARKit label that fits the motion of a blendshape best. */
interface MotionMatch {
  label: ShapeLabel
  confidence: number
  score: number
  /** Returns the score of any label, given by its ARKit name. */
  scoreOf(name: string): number
  /** Fraction of the motion on the person's left. */
  left: number
}

/** The label found by motion overrules the name only if its score exceeds the score of the name's label by more than this. */
const OVERRULE_LEAD = 0.2
/** If at least this fraction of the motion is on one side of the face, the motion overrules a name that contains the other side. */
const ONE_SIDE = 0.85
/** Confidence of a shape that is recognised only by its name. */
const BY_NAME = 0.6

/** Blendshapes and eye positions of a face. */
export interface RecognisedFace {
  /** One entry per target. */
  shapes: RecognisedShape[]
  /** Centres of the left and right eye; undefined if no target closes lids. */
  eyes: readonly [left: Vector, right: Vector] | undefined
}

/**
 * Recognises the blendshapes of a face by their motion and their names. Corrections by the user overrule both. The result is deterministic.
 *
 * @param heads reference heads, whose ARKit shapes are compared with the blendshapes. Default: the built-in heads.
 */
export function recogniseShapes(
  skin: Skin,
  heads: readonly TemplateHead[] = templateHeads(),
): RecognisedFace {
  const { byMotion, eyes } = matchByMotion(skin, heads)
  const shapes = skin.targets.map((target, i) => {
    const hint = hintOfTarget(target)
    return { name: target.name, ...(correctedTo(target, hint) ?? decide(hint, byMotion.get(i))) }
  })
  return { shapes, eyes }
}

function matchByMotion(
  skin: Skin,
  heads: readonly TemplateHead[],
): { byMotion: Map<number, MotionMatch>; eyes: RecognisedFace['eyes'] } {
  const byMotion = new Map<number, MotionMatch>()
  const surface = movingSurface(skin)
  const frame = surface && faceFrame(surface)
  if (!frame) return { byMotion, eyes: undefined }
  const fields = withoutRejected(shapeFields(surface, frame), skin)
  const scores = correctScores(scoresOf(fields, heads), fields, skin.targets)
  const composites = compositesOf(fields, matchShapes(fields, scores))
  for (const [i, { target }] of fields.shapes.entries())
    if (skin.targets[target].correction !== undefined) composites.delete(i)
  const matches = matchShapes(fields, scores, composites)
  const indexOf = new Map(scores.labels.map((label, j) => [arkitName(label), j]))
  const confidences = confidencesOf(fields, matches, frame)
  for (const [i, { shape, label, score }] of matches.entries()) {
    const { target, field } = fields.shapes[shape]
    byMotion.set(target, {
      label,
      score,
      confidence: confidences[i],
      scoreOf: (name) => scores.scores[shape][indexOf.get(name) ?? -1] ?? 0,
      left: leftFraction(field, fields.weights),
    })
  }
  return { byMotion, eyes: frame.hasLids ? frame.eyes : undefined }
}

/** Drops the shapes that the user marked as no ARKit shape (correction `null`), so that they take no label from other shapes. */
function withoutRejected({ weights, shapes }: ShapeFields, { targets }: Skin): ShapeFields {
  return { weights, shapes: shapes.filter(({ target }) => targets[target].correction !== null) }
}

type Decision = Omit<RecognisedShape, 'name'>

function correctedTo({ correction }: SkinTarget, hint: NameHint | undefined): Decision | undefined {
  if (correction === undefined) return undefined
  return { shape: correction ?? undefined, confidence: 1, by: 'correction', hint, isMisnamed: false }
}

function decide(hint: NameHint | undefined, byMotion: MotionMatch | undefined): Decision {
  if (!hint)
    return byMotion && byMotion.confidence >= UNSURE ? byGeometry(byMotion, false) : unknown(undefined)
  const named = namedLabel(hint)
  // The name means no single ARKit shape, for example a viseme, an emotion, a proportion or a corrective.
  if (!named) return { ...unknown(hint), by: 'name' }
  const name = arkitName(named)
  if (!byMotion) return { shape: name, confidence: BY_NAME, by: 'name', hint, isMisnamed: false }
  if (arkitName(byMotion.label) === name)
    return {
      shape: name,
      confidence: Math.max(byMotion.confidence, 0.9),
      by: 'both',
      hint,
      isMisnamed: false,
    }
  const isOverruled = byMotion.confidence >= SURE && byMotion.score > byMotion.scoreOf(name) + OVERRULE_LEAD
  if (isOverruled) return byGeometry(byMotion, true)
  const side = byMotion.left > ONE_SIDE ? 'left' : byMotion.left < 1 - ONE_SIDE ? 'right' : undefined
  if (side && named.side !== 'both' && named.side !== side)
    return byGeometry({ ...byMotion, label: mirroredLabel(named), confidence: BY_NAME }, true)
  return { shape: name, confidence: BY_NAME, by: 'name', hint, isMisnamed: false }
}

function unknown(hint: NameHint | undefined): Decision {
  return { shape: undefined, confidence: 0, by: 'none', hint, isMisnamed: false }
}

/** Returns the ARKit shape that a name means; undefined if the name means several shapes or none, or is only similar to a shape (`like`). */
function namedLabel({ match, shapes, side }: NameHint): ShapeLabel | undefined {
  if (match === 'like') return undefined
  if (match === 'part') {
    const label = shapes.length === 1 ? labelOf(shapes[0]) : undefined
    return label && side ? { ...label, side: side === 'Left' ? 'left' : 'right' } : label
  }
  const labels = shapes.map(labelOf)
  const [first, second] = labels
  if (labels.length === 1) return first
  const isPair = labels.length === 2 && first && second && first.family === second.family
  return isPair ? { family: first.family, side: 'both' } : undefined
}

function byGeometry({ label, confidence }: MotionMatch, isMisnamed: boolean): Decision {
  return {
    shape: arkitName(label),
    confidence,
    by: 'geometry',
    hint: hintOfLabel(label, confidence),
    isMisnamed,
  }
}

/** Returns the hint that `hintOf` would return for the label's ARKit name, but with a rank that falls as the confidence rises. */
function hintOfLabel(label: ShapeLabel, confidence: number): NameHint {
  const hint = {
    kind: 'expression',
    match: 'same',
    side: label.side === 'both' ? undefined : label.side === 'left' ? 'Left' : 'Right',
    rank: Math.round(1000 * (1 - confidence)),
  } as const
  const sided = (side: 'left' | 'right') => arkitName({ ...label, side })
  const isHalf = isCentral(label.family) && label.side !== 'both'
  if (isHalf) return { ...hint, match: 'part', shapes: [label.family] }
  if (label.side !== 'both' || isCentral(label.family) || isShifted(label.family))
    return { ...hint, shapes: [arkitName(label)] }
  return { ...hint, shapes: [sided('left'), sided('right')] }
}
