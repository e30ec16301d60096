/** Numbers of an attribute, whatever it is stored as: quantised, interleaved or plain. */
export function coordinates(
  attribute: { count: number; getComponent(i: number, k: number): number },
  size = 3,
): Float32Array {
  const out = new Float32Array(size * attribute.count)
  for (let i = 0; i < out.length; i++) out[i] = attribute.getComponent(Math.floor(i / size), i % size)
  return out
}
