/**
 * Names of a rig. Values are ARKit names without a side, separated by spaces. Names without a side mean both sides.
 * A `*` in a name marks the position of the side; otherwise the side is at either end. `a|b` is a on the left and b on the right.
 */
export interface RigNames {
  /** Page that lists the names. */
  source: string
  /** Names of the same shapes; several values are moved at once. */
  same?: Readonly<Record<string, string>>
  /** Names of parts of a shape, such as its upper half, that add up to the shape. */
  parts?: Readonly<Record<string, string>>
  /** Names of other shapes that move the same skin in the same way, closest first. */
  like?: Readonly<Record<string, string>>
  /** Visemes and emotions, matched like `like`. */
  visemes?: Readonly<Record<string, string>>
  emotions?: Readonly<Record<string, string>>
  /** Names of shapes that wrinkle no skin. */
  other?: readonly string[]
}
