/** Finds where a surface intersects itself. */

/** Edge length of the cubes into which triangles are sorted, metres. */
const CUBE = 0.003

type Point = readonly [number, number, number]

/** Line segment along which two triangles intersect. */
export interface Cut {
  from: Point
  to: Point
}

/**
 * Finds the line segments along which triangles intersect. Skips pairs of triangles with a common corner.
 *
 * @param positions x, y and z of each vertex, metres.
 */
export function cutsOf(positions: ArrayLike<number>, triangles: ArrayLike<number>): Cut[] {
  const cuts: Cut[] = []
  const corner = (k: number): Point => {
    const i = 3 * triangles[k]
    return [positions[i], positions[i + 1], positions[i + 2]]
  }
  const all = Array.from({ length: triangles.length / 3 }, (_, t) => [
    corner(3 * t),
    corner(3 * t + 1),
    corner(3 * t + 2),
  ])
  const cubes = new Map<string, number[]>()
  const seen = new Set<number>()
  for (const [t, own] of all.entries()) {
    const range = [0, 1, 2].map((axis) => {
      const values = own.map((point) => Math.floor(point[axis] / CUBE))
      return [Math.min(...values), Math.max(...values)]
    })
    for (let x = range[0][0]; x <= range[0][1]; x++) {
      for (let y = range[1][0]; y <= range[1][1]; y++) {
        for (let z = range[2][0]; z <= range[2][1]; z++) {
          const key = `${x} ${y} ${z}`
          const cube = cubes.get(key) ?? []
          if (cube.length === 0) cubes.set(key, cube)
          for (const other of cube) {
            const pair = other * all.length + t
            if (seen.has(pair) || touch(own, all[other])) continue
            seen.add(pair)
            const [from, to = from] = [...crossings(own, all[other]), ...crossings(all[other], own)]
            if (from) cuts.push({ from, to })
          }
          cube.push(t)
        }
      }
    }
  }
  return cuts
}

/** Returns the total length, metres, of the cuts that are farther than `metres` from all of `others`. */
export function lengthAway(cuts: readonly Cut[], others: readonly Cut[], metres: number): number {
  return cuts.reduce((sum, { from, to }) => {
    const isNear = others.some((other) => distanceTo(middleOf(from, to), other) <= metres)
    return isNear ? sum : sum + Math.hypot(...minus(to, from))
  }, 0)
}

function middleOf(a: Point, b: Point): Point {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2]
}

function distanceTo(point: Point, { from, to }: Cut): number {
  const along = minus(to, from)
  const length = dot(along, along)
  const at = length === 0 ? 0 : Math.min(Math.max(dot(minus(point, from), along) / length, 0), 1)
  return Math.hypot(...[0, 1, 2].map((axis) => point[axis] - from[axis] - at * along[axis]))
}

function touch(a: readonly Point[], b: readonly Point[]): boolean {
  return a.some((p) => b.some((q) => p[0] === q[0] && p[1] === q[1] && p[2] === q[2]))
}

/**
 * Returns the points where edges of one triangle pass through another (T. Möller, B. Trumbore, "Fast, Minimum Storage
 * Ray-Triangle Intersection", 1997).
 */
function crossings(edges: readonly Point[], [a, b, c]: readonly Point[]): Point[] {
  const [u, v] = [minus(b, a), minus(c, a)]
  return edges.flatMap((from, k) => {
    const along = minus(edges[(k + 1) % 3], from)
    const p = cross(along, v)
    const determinant = dot(u, p)
    if (determinant === 0) return []
    const offset = minus(from, a)
    const x = dot(offset, p) / determinant
    const q = cross(offset, u)
    const y = dot(along, q) / determinant
    const at = dot(v, q) / determinant
    if (!(x >= 0 && y >= 0 && x + y <= 1 && at >= 0 && at <= 1)) return []
    return [[from[0] + at * along[0], from[1] + at * along[1], from[2] + at * along[2]] as const]
  })
}

function minus(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

function cross(a: Point, b: Point): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
