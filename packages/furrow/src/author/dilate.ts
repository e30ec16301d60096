/**
 * Carries values outwards from the texels that have one, ring by ring: a new texel is the mean of those of its eight
 * neighbours that were there before its ring. Mipmaps and filtering then see no seam round an island.
 *
 * @param known 1 where a texel has a value; changed: what was reached is 1 too.
 * @param maps values per texel, one after the other in each map; changed.
 * @param rings how far to go, in texels.
 */
export function dilate(
  known: Uint8Array,
  width: number,
  maps: readonly { data: Float32Array; channels: number }[],
  rings: number,
): void {
  const height = known.length / width
  let border: number[] = []
  for (let i = 0; i < known.length; i++)
    if (!known[i] && hasNeighbour(known, i, width, height)) border.push(i)
  for (let ring = 0; ring < rings && border.length > 0; ring++) {
    const filled = border
    for (const i of filled) fill(known, i, width, height, maps)
    for (const i of filled) known[i] = 1
    const next = new Set<number>()
    for (const i of filled) {
      for (const j of neighbours(i, width, height)) if (!known[j]) next.add(j)
    }
    border = [...next]
  }
}

function fill(
  known: Uint8Array,
  i: number,
  width: number,
  height: number,
  maps: readonly { data: Float32Array; channels: number }[],
): void {
  const from = neighbours(i, width, height).filter((j) => known[j])
  for (const { data, channels } of maps) {
    for (let k = 0; k < channels; k++) {
      let sum = 0
      for (const j of from) sum += data[channels * j + k]
      data[channels * i + k] = sum / from.length
    }
  }
}

function hasNeighbour(known: Uint8Array, i: number, width: number, height: number): boolean {
  return neighbours(i, width, height).some((j) => known[j])
}

function neighbours(i: number, width: number, height: number): number[] {
  const [x, y] = [i % width, Math.floor(i / width)]
  const found: number[] = []
  for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); v++) {
    for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); u++) {
      if (u !== x || v !== y) found.push(v * width + u)
    }
  }
  return found
}
