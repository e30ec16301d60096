import type { RecognisedShape } from 'furrow/internal'
import { EVIDENCE, SHAPE_KINDS, SHAPES } from '../../labels/blendshapes.ts'
import type { ShapeRow } from '../../session/shape-editor.ts'

/** Returns the label of a recognised blendshape: its ARKit name or its kind. Empty if it was not recognised yet. */
export function recognisedLabel(recognised: RecognisedShape | undefined): string {
  if (!recognised) return ''
  const { shape, hint, by } = recognised
  if (by === 'correction') return ''
  if (shape !== undefined) return shape
  if (hint && hint.kind !== 'expression') return SHAPE_KINDS[hint.kind]
  return hint?.shapes.join(' + ') || SHAPES.unknown
}

/** Returns the label by which a blendshape can be searched: its correction, or the recognised label. */
export function shapeLabel({ recognised, correction }: ShapeRow): string {
  return correction === undefined ? recognisedLabel(recognised) : (correction ?? SHAPES.none)
}

/** Returns the reason for a blendshape's label: its motion, its name, both, or a correction. */
export function evidenceLabel(row: ShapeRow): string {
  const { recognised, correction } = row
  if (correction !== undefined) return EVIDENCE.correction
  return isUnknown(row) || !recognised ? '' : EVIDENCE[recognised.by]
}

/** Returns the confidence of a recognised ARKit shape, 0..1. Undefined for corrected blendshapes, and for shapes outside ARKit. */
export function confidenceOf({ recognised, correction }: ShapeRow): number | undefined {
  return correction === undefined && recognised?.shape !== undefined ? recognised.confidence : undefined
}

export function isUnknown({ recognised, correction }: ShapeRow): boolean {
  return correction === undefined && recognisedLabel(recognised) === SHAPES.unknown
}
