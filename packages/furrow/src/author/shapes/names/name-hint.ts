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
  /** Shape that hides a part of the mesh, mostly by shrinking it. */
  | 'hidden'
  /** Known shape that wrinkles no skin, for example of the tongue, a pupil or lashes. */
  | 'other'

/** Meaning of a blendshape's name. */
export interface NameHint {
  kind: ShapeKind
  /** ARKit names of similar shapes; `match` tells how they relate to the blendshape. Empty if there are none. */
  shapes: readonly string[]
  /** `same`: the blendshape is the sum of `shapes`. `part`: it is a part of each of them. `like`: it moves the same skin as they do. */
  match: 'same' | 'part' | 'like'
  /** Side that the name contains. */
  side: 'Left' | 'Right' | undefined
  /** Rank among blendshapes that match the same shape, 0 or more. Lower ranks are more similar. */
  rank: number
}
