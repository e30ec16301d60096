import type { Skin } from 'furrow/author'
import { type RecognisedShape, recogniseShapes } from 'furrow/internal'

/** Facial shape of one blendshape, recognised by its motion and name, or stated in the file. */
export interface ShapeReport extends Pick<RecognisedShape, 'by'> {
  blendshape: string
  /** Name of the ARKit shape. Null if the blendshape is unknown, or matches several ARKit shapes. */
  shape: string | null
  /** Kind of shape that the name suggests, e.g. `viseme`. Only if `shape` is null. */
  kind?: string
  /** Confidence of the recognition, 0..1. */
  confidence: number
}

export function inspectShapes(skin: Skin): ShapeReport[] {
  return recogniseShapes(skin).shapes.map(({ name, shape, confidence, by, hint }) => ({
    blendshape: name,
    shape: shape ?? null,
    ...(shape === undefined && hint && { kind: hint.kind }),
    confidence: Math.round(100 * confidence) / 100,
    by,
  }))
}
