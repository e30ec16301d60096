import type { Skin } from 'furrow/author'
import { type RecognisedShape, recogniseShapes } from 'furrow/internal'

/** A blendshape of the skin, recognised by its motion and its name, or corrected. */
export interface ShapeReport extends Pick<RecognisedShape, 'by'> {
  blendshape: string
  /** ARKit's name; null where it is unknown, or no single one of ARKit's shapes. */
  shape: string | null
  /** Kind by its name where it is no single shape, such as `viseme`. */
  kind?: string
  /** 0..1 */
  confidence: number
}

/** Tells what the blendshapes of a skin are. */
export function inspectShapes(skin: Skin): ShapeReport[] {
  return recogniseShapes(skin).shapes.map(({ name, shape, confidence, by, hint }) => ({
    blendshape: name,
    shape: shape ?? null,
    ...(shape === undefined && hint && { kind: hint.kind }),
    confidence: Math.round(100 * confidence) / 100,
    by,
  }))
}
