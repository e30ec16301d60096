import type { Skin, Surface } from './surface.ts'

/** Texels by which the skin goes on beyond the islands of its texture, in its own plane: slopes there are its own. */
const MARGIN = 3

/**
 * Visits the texels of a skin, those whose centres its triangles cover and a few round its islands, with where they lie on it.
 *
 * @param wanted tells of each triangle whether to visit its texels.
 * @param visit is given the texel's index, row by row, the triangle and the shares of its corners, which are below 0 beyond an island.
 */
export function visitTexels(
  { uvs, indices }: Pick<Skin, 'uvs' | 'indices'>,
  { triangleOf }: Surface,
  size: number,
  wanted: (triangle: number) => boolean,
  visit: (texel: number, triangle: number, a: number, b: number, c: number) => void,
): void {
  const nearest = new Float32Array(size * size).fill(Infinity)
  const owner = new Int32Array(size * size).fill(-1)
  const corners = (t: number) => {
    const vertex = (k: number) => 2 * indices[3 * triangleOf[t]! + k]!
    return [0, 1, 2].map((k) => [uvs[vertex(k)]! * size - 0.5, uvs[vertex(k) + 1]! * size - 0.5]) as Corners
  }
  for (let t = 0; t < triangleOf.length; t++) claim(corners(t), t, size, nearest, owner)
  const shares = new Float64Array(3)
  let last = -1
  let placed: Corners = [
    [0, 0],
    [0, 0],
    [0, 0],
  ]
  const known = new Int8Array(triangleOf.length).fill(-1)
  for (let texel = 0; texel < owner.length; texel++) {
    const t = owner[texel]!
    if (t < 0) continue
    if (known[t]! < 0) known[t] = wanted(t) ? 1 : 0
    if (known[t] === 0) continue
    if (t !== last) placed = corners(t)
    last = t
    if (!sharesOf(placed, texel % size, Math.floor(texel / size), shares)) continue
    visit(texel, t, shares[0]!, shares[1]!, shares[2]!)
  }
}

type Corners = [[number, number], [number, number], [number, number]]

/** Gives a triangle the texels that it covers, and those near it that no other is nearer to. */
function claim(
  corners: Corners,
  triangle: number,
  size: number,
  nearest: Float32Array,
  owner: Int32Array,
): void {
  const [[ax, ay], [bx, by], [cx, cy]] = corners
  const det = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
  if (Math.abs(det) < 1e-9) return
  const firstRow = Math.max(Math.ceil(Math.min(ay, by, cy) - MARGIN), 0)
  const lastRow = Math.min(Math.floor(Math.max(ay, by, cy) + MARGIN), size - 1)
  const firstColumn = Math.max(Math.ceil(Math.min(ax, bx, cx) - MARGIN), 0)
  const lastColumn = Math.min(Math.floor(Math.max(ax, bx, cx) + MARGIN), size - 1)
  const turn = Math.sign(det)
  const edges = corners.map(([x, y], k) => {
    const [toX, toY] = corners[(k + 1) % 3]!
    const length = Math.hypot(toX - x, toY - y) || 1
    return [(turn * (toY - y)) / length, (-turn * (toX - x)) / length, x, y] as const
  })
  for (let row = firstRow; row <= lastRow; row++) {
    for (let column = firstColumn; column <= lastColumn; column++) {
      let outside = -Infinity
      for (const [nx, ny, x, y] of edges) outside = Math.max(outside, nx * (column - x) + ny * (row - y))
      if (outside > MARGIN) continue
      const texel = row * size + column
      const distance = Math.max(0, outside)
      if (distance >= nearest[texel]!) continue
      nearest[texel] = distance
      owner[texel] = triangle
    }
  }
}

function sharesOf([[ax, ay], [bx, by], [cx, cy]]: Corners, x: number, y: number, out: Float64Array): boolean {
  const det = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
  if (det === 0) return false
  out[1] = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / det
  out[2] = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / det
  out[0] = 1 - out[1]! - out[2]!
  return true
}
