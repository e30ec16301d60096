/**
 * The names of a rig. Values are ARKit's names without a side, separated by spaces. A name without a side means both sides. A `*` in a name
 * marks a side in its midst; others have their side at the end or the beginning. `a|b` is a on the left and b on the right.
 */
export interface RigNames {
  /** Page that lists the names. */
  source: string
  /** Names of these same shapes; several are moved at once. */
  same?: Readonly<Record<string, string>>
  /** Names of parts of a shape, such as its upper half: together they are the whole. */
  parts?: Readonly<Record<string, string>>
  /** Names of other shapes that move the same skin in the same way, the closest first. */
  like?: Readonly<Record<string, string>>
  /** `like` for shapes that are no expressions. */
  visemes?: Readonly<Record<string, string>>
  emotions?: Readonly<Record<string, string>>
  /** Names of shapes that wrinkle no skin. */
  other?: readonly string[]
}
