import { FurrowError } from 'furrow'
import { MAX_SKIN_TRIANGLES } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import type { GltfMesh } from '../json/gltf-json.ts'

/** First and last primitive mode with triangles (glTF 2.0, 3.7.2.1). Mode 5 is TRIANGLE_STRIP. */
const TRIANGLES = 4
const TRIANGLE_FAN = 6
/**
 * Limits for the number of triangles times the number of blendshapes. `furrow auto` takes time proportional to this
 * product. The limit for a file is the larger of the fixed limit and the limit per byte times the size of the file. The
 * product is less than 1 per byte for ordinary faces, and up to 3 for compressed faces. A small hostile file can reach
 * thousands per byte, because blendshapes can share accessors.
 */
const MAX_MORPHED_TRIANGLES = 6_000_000
const MAX_MORPHED_TRIANGLES_PER_BYTE = 3

/**
 * Checks the size of meshes before decoding, with the counts in the JSON.
 *
 * @param meshName name of a mesh or its node. Only this mesh is checked. Default: all meshes.
 * @throws FurrowError that names the first mesh with too many triangles, or too many triangles times blendshapes.
 */
export function checkTriangles({ json, fileBytes }: Glb, who: string, meshName?: string): void {
  const { meshes = [], nodes = [], accessors = [] } = json
  const maxMorphed = Math.max(MAX_MORPHED_TRIANGLES, MAX_MORPHED_TRIANGLES_PER_BYTE * fileBytes)
  const countOf = (accessor = -1) => (accessors[accessor] as { count?: number } | undefined)?.count ?? 0
  for (const [index, mesh] of meshes.entries()) {
    const names = [mesh.name, ...nodes.filter((node) => node.mesh === index).map(({ name }) => name)]
    if (meshName !== undefined && !names.includes(meshName)) continue
    const largest = Math.max(0, ...trianglesByMaterial(mesh, countOf).values())
    const targets = Math.max(0, ...mesh.primitives.map(({ targets = [] }) => targets.length))
    const tooMany = (items: string, value: number, limit: string) =>
      new FurrowError({
        code: 'out-of-range',
        who,
        problem: `the mesh "${mesh.name ?? index}" has too many ${items}`,
        value,
        limit,
        remedy: 'decimate it (the maps keep the detail), or name another mesh with --mesh',
      })
    if (largest > MAX_SKIN_TRIANGLES) {
      const limit = `${MAX_SKIN_TRIANGLES.toLocaleString('en')} triangles of one material`
      throw tooMany('triangles', largest, limit)
    }
    if (largest * targets > maxMorphed) {
      const limit = `${maxMorphed.toLocaleString('en')} in a file of ${fileBytes.toLocaleString('en')} bytes`
      throw tooMany('triangles times blendshapes', largest * targets, limit)
    }
  }
}

/** Counts the triangles of primitives with blendshapes, per material index. */
function trianglesByMaterial(
  { primitives }: GltfMesh,
  countOf: (accessor?: number) => number,
): Map<number | undefined, number> {
  const sums = new Map<number | undefined, number>()
  for (const { mode = TRIANGLES, targets = [], indices, attributes, material } of primitives) {
    if (mode < TRIANGLES || mode > TRIANGLE_FAN || targets.length === 0) continue
    const corners = countOf(indices ?? attributes?.POSITION)
    const count = mode === TRIANGLES ? Math.floor(corners / 3) : corners
    sums.set(material, (sums.get(material) ?? 0) + count)
  }
  return sums
}
