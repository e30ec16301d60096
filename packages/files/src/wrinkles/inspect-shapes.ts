import type { Skin } from 'furrow/author'
import { type RecognisedShape, recogniseShapes } from 'furrow/internal'

/** A blendshape of the skin, recognised by motion and name, or corrected by the file. */
export interface ShapeReport extends Pick<RecognisedShape, 'by'> {
  blendshape: string
  /** Name of the ARKit shape; null if unknown, or if it matches no single ARKit shape. */
  shape: string | null
  /** Kind guessed from the name if `shape` is null, such as `viseme`. */
  kind?: string
  /** 0..1 */
  confidence: number
}

/** Recognises the blendshapes of a skin. */
export function inspectShapes(skin: Skin): ShapeReport[] {
  return recogniseShapes(skin).shapes.map(({ name, shape, confidence, by, hint }) => ({
    blendshape: name,
    shape: shape ?? null,
    ...(shape === undefined && hint && { kind: hint.kind }),
    confidence: Math.round(100 * confidence) / 100,
    by,
  }))
}
