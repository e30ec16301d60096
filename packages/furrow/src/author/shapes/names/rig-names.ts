/**
 * Names of a rig's blendshapes, and the ARKit shapes that they correspond to.
 *
 * Each key is a blendshape name in the rig. Files may add a side, such as `L`, at either end of the name, or in place of a `*`. Without a
 * side, the name means both sides.
 *
 * Each value lists ARKit names without a side, separated by spaces. `a|b` means shape `a` on the left side and shape `b` on the right side.
 */
export interface RigNames {
  /** Page that lists the names. */
  source: string
  /** Blendshapes that equal an ARKit shape, or the sum of several. */
  same?: Readonly<Record<string, string>>
  /** Blendshapes that are a part of an ARKit shape, such as its upper half. The parts add up to the shape. */
  parts?: Readonly<Record<string, string>>
  /** Blendshapes that move the same skin as an ARKit shape in a similar way. The most similar ones come first. */
  like?: Readonly<Record<string, string>>
  /** Mouth shapes of sounds. The values are similar ARKit shapes, as in `like`. */
  visemes?: Readonly<Record<string, string>>
  /** Movements of the complete face. The values are similar ARKit shapes, as in `like`. */
  emotions?: Readonly<Record<string, string>>
  /** Blendshapes that wrinkle no skin. */
  other?: readonly string[]
}
