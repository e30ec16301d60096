/** Use of a blendshape, guessed from its name. */
export type ShapeKind =
  /** Movement of one part of the face. */
  | 'expression'
  /** Mouth shape of a sound. */
  | 'viseme'
  /** Movement of the complete face. */
  | 'emotion'
  /** Correction for a combination of shapes or a joint's pose. */
  | 'corrective'
  /** Proportion of the character, such as `male` or `fat`. */
  | 'body'
  /** Geometry hidden by compressing it. */
  | 'hidden'
  /** Known shape that wrinkles no skin: tongues, pupils, lashes. */
  | 'other'

/** Kind, shapes and side of a blendshape, from its name. */
export interface NameHint {
  kind: ShapeKind
  /** ARKit names of related shapes, see `match`; empty if none is related. */
  shapes: readonly string[]
  /** `same`: all these shapes at once. `part`: a part of each shape. `like`: moves the same skin. */
  match: 'same' | 'part' | 'like'
  /** Side in the name. */
  side: 'Left' | 'Right' | undefined
  /** Rank among shapes that resemble the same one; 0 is the closest. */
  rank: number
}
