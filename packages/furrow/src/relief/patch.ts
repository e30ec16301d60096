import { MAX_LEVEL } from './welded-edges.ts'

/** Sum of the three integer barycentric coordinates of a point in a triangle. It is a power of two, so that halving gives integers. */
export const COORDINATE_SUM = 2 ** (MAX_LEVEL + 4)

/** A point in a patch. A patch is a triangle that is subdivided. */
interface Point {
  /** Integer barycentric coordinate of the first corner, 0..`COORDINATE_SUM`. */
  x: number
  /** Integer barycentric coordinate of the second corner. */
  y: number
  /** Index of the vertex in the dense mesh. */
  index: number
}

/** Rules for splitting a patch. */
export interface PatchRules {
  /** Vertex indices of the corners. */
  corners: readonly [number, number, number]
  /** Number of halvings of the edges from corner 0 to 1, 1 to 2 and 2 to 0. */
  levels: readonly [number, number, number]
  /** Whether to halve an edge inside the patch. `dx` and `dy` are the differences in `x` and `y` between the ends of the edge. */
  isLong(dx: number, dy: number): boolean
  /** Returns the vertex at a position on edge 0, 1 or 2 of the patch. `part` is this position, from 0 at the edge's first corner to 1. */
  onEdge(edge: number, part: number): number
  /** Returns the vertex inside the patch at coordinates `x` and `y`. Calls with the same coordinates must return the same vertex. */
  inside(x: number, y: number): number
}

/**
 * Subdivides a triangle by halving all edges that are too long, recursively. Whether an edge is halved depends only on the edge and not on
 * the triangle. Both triangles at an edge are therefore split at the same point, and there are no T-junctions.
 *
 * @param emit receives the three vertices of each new triangle. New triangles have the winding of the patch.
 */
export function splitPatch(rules: PatchRules, emit: (a: number, b: number, c: number) => void): void {
  const middle = (p: Point, q: Point): Point | null => {
    const edge = edgeOf(p, q)
    const [x, y] = [(p.x + q.x) / 2, (p.y + q.y) / 2]
    if (edge < 0) {
      if (!Number.isInteger(x) || !Number.isInteger(y) || !rules.isLong(q.x - p.x, q.y - p.y)) return null
      return { x, y, index: rules.inside(x, y) }
    }
    const [from, to] = [alongEdge(p, edge), alongEdge(q, edge)]
    if (Math.abs(to - from) <= 2 ** -rules.levels[edge]) return null
    return { x, y, index: rules.onEdge(edge, (from + to) / 2) }
  }
  const split = (p: Point, q: Point, r: Point): void => {
    const [pq, qr, rp] = [middle(p, q), middle(q, r), middle(r, p)]
    if (pq && qr && rp) {
      split(p, pq, rp)
      split(pq, q, qr)
      split(rp, qr, r)
      split(pq, qr, rp)
    } else if (pq && qr) splitTwo(p, pq, q, qr, r)
    else if (qr && rp) splitTwo(q, qr, r, rp, p)
    else if (rp && pq) splitTwo(r, rp, p, pq, q)
    else if (pq) splitOne(p, pq, q, r)
    else if (qr) splitOne(q, qr, r, p)
    else if (rp) splitOne(r, rp, p, q)
    else emit(p.index, q.index, r.index)
  }
  const splitOne = (p: Point, pq: Point, q: Point, r: Point): void => {
    split(p, pq, r)
    split(pq, q, r)
  }
  const splitTwo = (p: Point, pq: Point, q: Point, qr: Point, r: Point): void => {
    split(pq, q, qr)
    split(p, pq, qr)
    split(p, qr, r)
  }
  const [a, b, c] = rules.corners
  split(
    { x: COORDINATE_SUM, y: 0, index: a },
    { x: 0, y: COORDINATE_SUM, index: b },
    { x: 0, y: 0, index: c },
  )
}

/** Returns the index of the patch's edge that contains both points, or -1. */
function edgeOf(p: Point, q: Point): number {
  if (p.x + p.y === COORDINATE_SUM && q.x + q.y === COORDINATE_SUM) return 0
  if (p.x === 0 && q.x === 0) return 1
  return p.y === 0 && q.y === 0 ? 2 : -1
}

/** Returns the position of a point along an edge of the patch, from 0 at the edge's first corner to 1. */
function alongEdge({ x, y }: Point, edge: number): number {
  if (edge === 0) return y / COORDINATE_SUM
  return edge === 1 ? 1 - y / COORDINATE_SUM : x / COORDINATE_SUM
}
