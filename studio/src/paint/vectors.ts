export function cross(a: ArrayLike<number>, b: ArrayLike<number>): Float64Array {
  return Float64Array.of(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
}

export function distanceBetween(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2])
}

/**
 * Returns the squared distance from a position to a segment (Ericson, Real-Time Collision Detection, 5.1.2).
 *
 * @param from index of the start point's x in `points`.
 * @param to index of the end point's x in `points`.
 */
export function squaredDistance(
  points: ArrayLike<number>,
  from: number,
  to: number,
  position: ArrayLike<number>,
): number {
  const [dx, dy, dz] = [
    position[0] - points[from],
    position[1] - points[from + 1],
    position[2] - points[from + 2],
  ]
  const [ex, ey, ez] = [
    points[to] - points[from],
    points[to + 1] - points[from + 1],
    points[to + 2] - points[from + 2],
  ]
  const along = dx * ex + dy * ey + dz * ez
  const length = ex * ex + ey * ey + ez * ez
  const t = along <= 0 || length === 0 ? 0 : along >= length ? 1 : along / length
  return (dx - t * ex) ** 2 + (dy - t * ey) ** 2 + (dz - t * ez) ** 2
}
