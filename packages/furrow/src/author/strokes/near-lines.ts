import { interpolate } from '../../math/barycentrics.ts'
import type { SkinTexels } from '../skin/skin-texels.ts'
import { cornersOf, triangleBox } from '../skin/surface.ts'
import type { LineGrid } from './line-grid.ts'

/** Visits the texels that may have lines near them, with their position on the skin and its normal there. */
export function visitTexelsNearLines(
  texels: SkinTexels,
  grid: LineGrid,
  visit: (texel: number, x: number, y: number, z: number, normal: Float64Array) => void,
  progress?: (fraction: number) => void,
): void {
  const { surface } = texels
  const [normal, position] = [new Float64Array(3), new Float64Array(3)]
  const [low, high] = [new Float64Array(3), new Float64Array(3)]
  texels.visit(
    (triangle) => {
      triangleBox(surface, triangle, low, high)
      return grid.isNear(low, high)
    },
    (texel, triangle, wa, wb, wc) => {
      const [a, b, c] = cornersOf(surface, triangle)
      interpolate(position, surface.points, 3, a, b, c, wa, wb, wc)
      // Beyond an island positions are in the plane of its border triangle, but normals stay those of its edge.
      const [na, nb, nc] = [Math.max(wa, 0), Math.max(wb, 0), Math.max(wc, 0)]
      interpolate(normal, surface.normals, 3, a, b, c, na, nb, nc)
      visit(texel, position[0], position[1], position[2], normal)
    },
    progress,
  )
}
