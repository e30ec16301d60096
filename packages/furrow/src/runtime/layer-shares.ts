/**
 * The shares of layers in what they are mixed into, as text of a shader: their influence, and less where its sum exceeds 1, which that of one
 * layer does not.
 *
 * @param influences of the layers, 0..1.
 */
export function sharesOf(influences: readonly string[]): readonly string[] {
  if (influences.length < 2) return influences
  const total = influences.join(' + ')
  return influences.map((influence) => `${influence} / max(1.0, ${total})`)
}
