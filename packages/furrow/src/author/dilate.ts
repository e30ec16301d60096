/**
 * Extends values outwards from the texels that have one, ring by ring: a new texel gets the mean of those of its eight
 * neighbours that had a value before its ring. Keeps mipmaps and filtering from showing seams round UV islands.
 *
 * @param known 1 where a texel has a value; set to 1 for the texels reached.
 * @param width of the map in texels.
 * @param maps `channels` values per texel, interleaved; changed.
 * @param rings how far to extend, in texels.
 */
export function dilate(
  known: Uint8Array,
  width: number,
  maps: readonly { data: Float32Array; channels: number }[],
  rings: number,
): void {
  const height = known.length / width
  let ring: number[] = []
  for (let i = 0; i < known.length; i++)
    if (!known[i] && hasKnownNeighbour(known, i, width, height)) ring.push(i)
  for (let count = 0; count < rings && ring.length > 0; count++) {
    for (const i of ring) fillFromNeighbours(known, i, width, height, maps)
    for (const i of ring) known[i] = 1
    const next = new Set<number>()
    for (const i of ring) {
      for (const j of neighbours(i, width, height)) if (!known[j]) next.add(j)
    }
    ring = [...next]
  }
}

function fillFromNeighbours(
  known: Uint8Array,
  i: number,
  width: number,
  height: number,
  maps: readonly { data: Float32Array; channels: number }[],
): void {
  const sources = neighbours(i, width, height).filter((j) => known[j])
  for (const { data, channels } of maps) {
    for (let k = 0; k < channels; k++) {
      let sum = 0
      for (const j of sources) sum += data[channels * j + k]
      data[channels * i + k] = sum / sources.length
    }
  }
}

function hasKnownNeighbour(known: Uint8Array, i: number, width: number, height: number): boolean {
  return neighbours(i, width, height).some((j) => known[j])
}

function neighbours(i: number, width: number, height: number): number[] {
  const [column, row] = [i % width, Math.floor(i / width)]
  const found: number[] = []
  for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
    for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
      if (x !== column || y !== row) found.push(y * width + x)
    }
  }
  return found
}
