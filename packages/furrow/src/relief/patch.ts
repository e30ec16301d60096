import { MAX_LEVEL } from './welded-edges.ts'

/** Sum of a point's integer barycentric coordinates: a power of two, large enough for the shortest edges. */
export const WHOLE = 2 ** (MAX_LEVEL + 4)

/** Point of a patch: barycentric coordinates of the first two corners, in units of 1 / `WHOLE`, and vertex index. */
interface Point {
  x: number
  y: number
  index: number
}

/** Rules for splitting a patch. */
export interface PatchRules {
  /** Vertex indices of the corners. */
  corners: readonly [number, number, number]
  /** Halvings of the edges from corner 0 to 1, 1 to 2 and 2 to 0. */
  levels: readonly [number, number, number]
  /** Tests whether an inner edge is too long. In patches that only join their neighbours, none is. */
  isLong(dx: number, dy: number): boolean
  /** Returns the vertex on an edge; `part` is the fraction of its length from the first corner. */
  onEdge(edge: number, part: number): number
  /** Returns the vertex at an inner point, always the same for the same coordinates. */
  inside(x: number, y: number): number
}

/**
 * Splits a triangle by halving edges that are too long, recursively. The decision depends only on the edge, so that neighbours agree and no
 * T-junctions appear.
 *
 * @param emit called with the vertices of each triangle, with the winding of the corners.
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
  split({ x: WHOLE, y: 0, index: a }, { x: 0, y: WHOLE, index: b }, { x: 0, y: 0, index: c })
}

/** Returns the edge of the patch on which both points lie, or -1. */
function edgeOf(p: Point, q: Point): number {
  if (p.x + p.y === WHOLE && q.x + q.y === WHOLE) return 0
  if (p.x === 0 && q.x === 0) return 1
  return p.y === 0 && q.y === 0 ? 2 : -1
}

/** Returns the position of a point along an edge, 0..1 from the edge's first corner. */
function alongEdge({ x, y }: Point, edge: number): number {
  if (edge === 0) return y / WHOLE
  return edge === 1 ? 1 - y / WHOLE : x / WHOLE
}
