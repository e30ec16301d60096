/**
 * Returns shader expressions for the mixing weights of layers. A weight is the layer's influence, divided by the sum of all influences if
 * the sum exceeds 1.
 *
 * @param influences shader expressions of the layers' influences, 0..1.
 */
export function sharesOf(influences: readonly string[]): readonly string[] {
  if (influences.length < 2) return influences
  const total = influences.join(' + ')
  return influences.map((influence) => `${influence} / max(1.0, ${total})`)
}
