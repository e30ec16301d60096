/**
 * Computes the size of the axis-aligned bounding box of points.
 *
 * @param positions packed xyz per point.
 */
export function boundingBoxSize(positions: ArrayLike<number>): [x: number, y: number, z: number] {
  const low = [Infinity, Infinity, Infinity]
  const high = [-Infinity, -Infinity, -Infinity]
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i])
    high[i % 3] = Math.max(high[i % 3], positions[i])
  }
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]]
}
