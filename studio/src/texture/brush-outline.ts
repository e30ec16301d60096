import type { PaintSkin } from '../paint/paint-skin.ts'

const CORNERS = 48

/**
 * Computes the outline of a round brush in the texture: an ellipse, because the texture stretches the skin.
 *
 * @param triangle index of a triangle in the surface. The circle of the brush is in its plane.
 * @param centre texture coordinates of the centre.
 * @param radius radius, millimetres.
 * @returns texture coordinates of the outline's corners.
 */
export function brushOutline(
  { skin, surface }: Pick<PaintSkin, 'skin' | 'surface'>,
  triangle: number,
  centre: readonly [u: number, v: number],
  radius: number,
): [u: number, v: number][] {
  const [a, b, c] = [0, 1, 2].map((k) => 3 * surface.corners[3 * triangle + k])
  const [p, q, r] = [0, 1, 2].map((k) => 2 * skin.indices[3 * surface.skinTriangles[triangle] + k])
  const edge = (from: number, to: number) =>
    [0, 1, 2].map((k) => surface.points[to + k] - surface.points[from + k])
  const uvEdge = (from: number, to: number) => [0, 1].map((k) => skin.uvs[to + k] - skin.uvs[from + k])
  // In the plane of the triangle, the first edge is (along, 0), the second (across, height).
  const [first, second] = [edge(a, b), edge(a, c)]
  const along = Math.hypot(...first)
  const across = first.reduce((sum, value, k) => sum + value * second[k], 0) / along
  const height = Math.sqrt(Math.max(0, second.reduce((sum, value) => sum + value * value, 0) - across ** 2))
  const [d, e] = [uvEdge(p, q), uvEdge(p, r)]
  return Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS
    const t = (radius * Math.sin(angle)) / height
    const s = (radius * Math.cos(angle) - t * across) / along
    return [centre[0] + s * d[0] + t * e[0], centre[1] + s * d[1] + t * e[1]]
  })
}
