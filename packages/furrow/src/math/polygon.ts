/**
 * Tests whether a point is inside a polygon by the even-odd rule. Counts how many edges cross the ray from the point to the right.
 *
 * @param polygon corners in order. An edge joins the last and the first corner.
 */
export function isInsidePolygon(
  polygon: readonly (readonly [number, number])[],
  x: number,
  y: number,
): boolean {
  let isInside = false
  for (let i = 0, k = polygon.length - 1; i < polygon.length; k = i++) {
    const [a, b] = [polygon[i], polygon[k]]
    if (a[1] > y === b[1] > y) continue
    if (x < a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) isInside = !isInside
  }
  return isInside
}
