import { triangleNormal, uvArea } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'

/**
 * Computes the mipmap level at which a height map must be sampled, for each vertex. Sharper levels contain details that are smaller than the
 * distance between vertices. The mesh cannot represent these details, so they would appear as spikes at single vertices (aliasing; see
 * L. Williams, "Pyramidal Parametrics", 1983). At the returned level, a texel is half as wide as the distance between vertices. The shortest
 * waves that the vertices can represent lose a quarter of their amplitude at this level, and three quarters at the next level.
 *
 * @param firstOf maps each vertex to the first vertex at the same position; see `firstVertices`.
 * @param edge distance between vertices after subdivision, in metres.
 * @param map size of the height map in texels.
 * @returns level of each vertex, 0 = full resolution. Vertices at one position have the same level.
 */
export function heightLevels(
  { positions, uvs, triangles }: CoarseMesh,
  firstOf: Uint32Array,
  edge: number,
  map: { width: number; height: number },
): Float32Array {
  const onSkin = new Float64Array(firstOf.length)
  const inMap = new Float64Array(firstOf.length)
  const normal = new Float64Array(3)
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const a = triangles[k]
    const b = triangles[k + 1]
    const c = triangles[k + 2]
    triangleNormal(normal, positions, a, b, c)
    const area = Math.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2) / 2
    const texels = uvArea(uvs, a, b, c) * map.width * map.height
    if (!(Number.isFinite(area) && Number.isFinite(texels))) continue
    for (let i = k; i < k + 3; i++) {
      onSkin[firstOf[triangles[i]]] += area
      inMap[firstOf[triangles[i]]] += texels
    }
  }
  const levels = new Float32Array(firstOf.length)
  for (let i = 0; i < levels.length; i++) {
    const first = firstOf[i]
    const texelsPerHalf = (edge / 2) * Math.sqrt(inMap[first] / onSkin[first])
    if (texelsPerHalf > 1 && texelsPerHalf < Infinity) levels[i] = Math.log2(texelsPerHalf)
  }
  return levels
}
