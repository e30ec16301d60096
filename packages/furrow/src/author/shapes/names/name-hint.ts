/** How a blendshape is used, as far as its name tells. */
export type ShapeKind =
  /** A movement of one part of the face. */
  | 'expression'
  /** The mouth in one sound. */
  | 'viseme'
  /** A movement of the whole face. */
  | 'emotion'
  /** A correction of other shapes in combination, or of a joint's pose. */
  | 'corrective'
  /** A proportion of the character, such as `male` or `fat`. */
  | 'body'
  /** Geometry that is hidden by compressing it. */
  | 'hidden'
  /** A known shape that wrinkles no skin: tongues, pupils, lashes. */
  | 'other'

/** Kind, shape and side of a blendshape, by its name. */
export interface NameHint {
  kind: ShapeKind
  /** ARKit's names of the shapes that it is, is a part of, or resembles; empty where it moves no skin as any of them does. */
  shapes: readonly string[]
  /** Whether it is all of these at once, a part of each, or another shape that moves the same skin. */
  match: 'same' | 'part' | 'like'
  /** The side in its name. */
  side: 'Left' | 'Right' | undefined
  /** Order among shapes that resemble one; 0 is the closest. */
  rank: number
}
