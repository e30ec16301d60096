import type { RecognisedShape } from 'furrow/internal'
import type { ShapeRow } from '../../session/shape-editor.ts'

/** Kinds of blendshapes that are none of ARKit's shapes. */
const KINDS: Readonly<Record<string, string>> = {
  viseme: 'speech',
  emotion: 'whole expression',
  corrective: 'correction of other shapes',
  body: 'proportion of the character',
  hidden: 'hides geometry',
  other: 'other',
}

const EVIDENCE: Readonly<Record<RecognisedShape['by'], string>> = {
  geometry: 'motion',
  name: 'name',
  both: 'both',
  correction: 'corrected',
  none: '',
}

/** Label where neither motion nor name tells the shape. */
const UNKNOWN = 'unknown'

/** Label of a recognised blendshape: ARKit's name, or its kind where it is none of ARKit's shapes. Empty where no result is there. */
export function recognisedLabel(recognised: RecognisedShape | undefined): string {
  if (!recognised) return ''
  const { shape, hint, by } = recognised
  if (by === 'correction') return ''
  if (shape !== undefined) return shape
  if (hint && hint.kind !== 'expression') return KINDS[hint.kind]
  return hint?.shapes.join(' + ') || UNKNOWN
}

/** Label of a blendshape with its correction, for filters. */
export function shapeLabel({ recognised, correction }: ShapeRow): string {
  return correction === undefined ? recognisedLabel(recognised) : (correction ?? 'none')
}

/** Evidence by which a blendshape counts as its label. */
export function evidenceLabel(row: ShapeRow): string {
  const { recognised, correction } = row
  if (correction !== undefined) return EVIDENCE.correction
  return isUnknown(row) || !recognised ? '' : EVIDENCE[recognised.by]
}

/** Confidence of a recognised shape, 0..1; undefined for corrections, and where it is none of ARKit's shapes. */
export function confidenceOf({ recognised, correction }: ShapeRow): number | undefined {
  return correction === undefined && recognised?.shape !== undefined ? recognised.confidence : undefined
}

export function isUnknown({ recognised, correction }: ShapeRow): boolean {
  return correction === undefined && recognisedLabel(recognised) === UNKNOWN
}
