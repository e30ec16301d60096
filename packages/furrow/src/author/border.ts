/**
 * What lies beyond the border of a UV island. Filtering and mipmaps read texels there, so every map needs values for them.
 *
 * | map | policy | why |
 * | --- | --- | --- |
 * | strokes and `auto`: height, occlusion, areas, strain | `extendPlanes` | they follow from the position on the skin: where it continues in the plane of its border triangle, both sides of a seam are filtered alike |
 * | metric | `copyNearest` | polygons and slopes read it at any texel, and a copied form stays positive definite |
 * | normals made from heights | none | they follow from the heights and the metric of the texels around them |
 * | `bake`: normal, height, occlusion; `targetArea` | `dilate` | only values of texels are known; means hide the steps between them |
 */

/** Texels beyond an island that filtering without mipmaps reads. */
export const FILTER_MARGIN = 3
/** Texels that maps with mipmaps need: at the third level filtering reads 12 texels beyond, and slopes are taken over two more. */
export const MIPMAP_MARGIN = 14

/** An edge of a triangle at the border of an island, in texels. */
export interface BorderEdge {
  triangle: number
  /** Where it starts, and the vector to its end. */
  x: number
  y: number
  dx: number
  dy: number
}

/**
 * Continues border triangles in their planes: each free texel within the margin goes to the triangle of the nearest edge.
 *
 * @param claim is given the texel and the triangle, again where a nearer edge is found later.
 */
export function extendPlanes(
  edges: Iterable<BorderEdge>,
  width: number,
  height: number,
  margin: number,
  isFree: (texel: number) => boolean,
  claim: (texel: number, triangle: number) => void,
): void {
  const nearest = new Float32Array(width * height).fill(Infinity)
  for (const { triangle, x, y, dx, dy } of edges) {
    const square = dx * dx + dy * dy || 1
    const firstRow = Math.max(Math.ceil(Math.min(y, y + dy) - margin), 0)
    const lastRow = Math.min(Math.floor(Math.max(y, y + dy) + margin), height - 1)
    const firstColumn = Math.max(Math.ceil(Math.min(x, x + dx) - margin), 0)
    const lastColumn = Math.min(Math.floor(Math.max(x, x + dx) + margin), width - 1)
    for (let row = firstRow; row <= lastRow; row++) {
      for (let column = firstColumn; column <= lastColumn; column++) {
        const texel = row * width + column
        if (!isFree(texel)) continue
        const t = Math.min(1, Math.max(0, ((column - x) * dx + (row - y) * dy) / square))
        const distance = Math.hypot(column - x - t * dx, row - y - t * dy)
        if (distance > margin || distance >= nearest[texel]) continue
        nearest[texel] = distance
        claim(texel, triangle)
      }
    }
  }
}

/**
 * Copies the value of the nearest texel that has one to all others, breadth first over the four neighbours.
 *
 * @param known 1 where a texel has a value.
 * @param width of the maps in texels.
 * @param maps one value per texel; changed.
 */
export function copyNearest(known: Uint8Array, width: number, maps: readonly Float32Array[]): void {
  const reached = Uint8Array.from(known)
  const queue = new Uint32Array(known.length)
  let end = 0
  for (let i = 0; i < reached.length; i++) if (reached[i]) queue[end++] = i
  for (let head = 0; head < end; head++) {
    const from = queue[head]
    const column = from % width
    const next = [
      column > 0 ? from - 1 : -1,
      column < width - 1 ? from + 1 : -1,
      from - width,
      from + width < known.length ? from + width : -1,
    ]
    for (const to of next) {
      if (to < 0 || reached[to]) continue
      reached[to] = 1
      for (const map of maps) map[to] = map[from]
      queue[end++] = to
    }
  }
}

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
