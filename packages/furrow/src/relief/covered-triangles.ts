import { rasterize } from '../math/rasterize.ts'
import { uvToTexels } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import type { Mask } from './height-fields.ts'
import { MAX_LEVEL } from './welded-edges.ts'

/** Returns one number per triangle: 1 if the triangle covers a texel that is 1 in the mask, 0 otherwise. */
export function coveredTriangles(mesh: CoarseMesh, mask: Mask): Uint8Array {
  const isCovered = coverage(mesh, mask)
  return Uint8Array.from({ length: Math.floor(mesh.triangles.length / 3) }, (_, t) => Number(isCovered(t)))
}

/** Creates a function that tests whether triangle `t` covers a texel that is 1 in a mask. */
export function coverage(
  { uvs, triangles }: CoarseMesh,
  { width, height, data }: Mask,
): (t: number) => boolean {
  const corners = new Float64Array(6)
  let any = 0
  const visit = (column: number, row: number) => {
    any |= data[clampTo(column, width) + clampTo(row, height) * width]
  }
  const box = [0, 0, width - 1, height - 1] as const
  return (t) => {
    uvToTexels(corners, uvs, triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2], width, height)
    if (!corners.every(Number.isFinite)) return false
    moveIntoTexture(corners, width, height)
    any = 0
    // A triangle smaller than a texel may cover no texel centre, so the texels of its corners are tested too.
    for (let k = 0; k < 6; k += 2) visit(Math.round(corners[k]), Math.round(corners[k + 1]))
    if (!any) rasterize(corners, 0, visit, box)
    return any > 0
  }
}

/** Returns the argument `halvings` of `splitMesh`. Edges of covered triangles get the maximum number of halvings; other edges get 0. */
export function maxHalvings(covered: Uint8Array): Float32Array {
  return Float32Array.from(
    { length: 3 * covered.length },
    (_, edge) => covered[Math.floor(edge / 3)] * MAX_LEVEL,
  )
}

/**
 * Moves a triangle into the texture by multiples of the texture's size. It still covers the same texels, because texture coordinates repeat.
 */
function moveIntoTexture(corners: Float64Array, width: number, height: number): void {
  for (let axis = 0; axis < 2; axis++) {
    const size = axis === 0 ? width : height
    const centre = (corners[axis] + corners[axis + 2] + corners[axis + 4]) / 3
    const moved = Math.floor((centre + 0.5) / size) * size
    for (let k = axis; k < 6; k += 2) corners[k] -= moved
  }
}

function clampTo(value: number, size: number): number {
  return Math.min(Math.max(value, 0), size - 1)
}
