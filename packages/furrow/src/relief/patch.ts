import { MAX_LEVEL } from './welded-edges.ts'

/** Barycentric coordinates in a patch are whole numbers that sum to this: halved until an edge is as short as any may be. */
export const WHOLE = 2 ** (MAX_LEVEL + 4)

/** A point of a patch: multiples of 1 / `WHOLE` of its first and second corner, and the index of its vertex. */
interface Point {
  x: number
  y: number
  index: number
}

/** Rules for splitting a patch. */
export interface PatchRules {
  /** Vertices of the three corners. */
  corners: readonly [number, number, number]
  /** Halvings of the edges from corner 0 to 1, 1 to 2 and 2 to 0. */
  levels: readonly [number, number, number]
  /** Whether an edge inside the patch is too long; a patch that is only joined to its neighbours has none. */
  isLong(dx: number, dy: number): boolean
  /** The vertex on an edge, `part` of it from its first corner on. */
  onEdge(edge: number, part: number): number
  /** The vertex inside, the same for the same numbers. */
  inside(x: number, y: number): number
}

/**
 * Splits a triangle: every edge that is too long is halved, and again. Whether it is follows from the edge alone, so that neighbours
 * always agree, and there are no T-junctions.
 *
 * @param emit takes the three vertices of each triangle, in the order of the corners.
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

/** The edge of the patch that two points are on, or -1. */
function edgeOf(p: Point, q: Point): number {
  if (p.x + p.y === WHOLE && q.x + q.y === WHOLE) return 0
  if (p.x === 0 && q.x === 0) return 1
  return p.y === 0 && q.y === 0 ? 2 : -1
}

/** How far along an edge of the patch a point is, 0..1 from the edge's first corner. */
function alongEdge({ x, y }: Point, edge: number): number {
  if (edge === 0) return y / WHOLE
  return edge === 1 ? 1 - y / WHOLE : x / WHOLE
}
