import { FurrowError } from 'furrow'
import { MAX_SKIN_TRIANGLES } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import type { GltfMesh } from '../json/gltf-json.ts'

/** Modes of a primitive: a list of triangles, and the last one of strips and fans. */
const TRIANGLES = 4
const TRIANGLE_FAN = 6
/**
 * Triangles times blendshapes in any file, and per byte in a larger one: each is measured. Faces have far less than one per byte, and up to
 * three when they are compressed; accessors that many blendshapes have in common make thousands.
 */
const MOVED = 6_000_000
const MOVED_PER_BYTE = 3

/**
 * Checks by the counts in the file that its meshes are not too large, before any of them is decoded.
 *
 * @param meshName only this mesh, or the mesh of a node of this name; all by default.
 * @throws FurrowError naming the mesh.
 */
export function checkTriangles({ json, fileBytes }: Glb, who: string, meshName?: string): void {
  const { meshes = [], nodes = [], accessors = [] } = json
  const mostMoved = Math.max(MOVED, MOVED_PER_BYTE * fileBytes)
  const countOf = (accessor = -1) => (accessors[accessor] as { count?: number } | undefined)?.count ?? 0
  for (const [index, mesh] of meshes.entries()) {
    const names = [mesh.name, ...nodes.filter((node) => node.mesh === index).map(({ name }) => name)]
    if (meshName !== undefined && !names.includes(meshName)) continue
    const largest = Math.max(0, ...trianglesByMaterial(mesh, countOf).values())
    const targets = Math.max(0, ...mesh.primitives.map(({ targets = [] }) => targets.length))
    const fault = (what: string, value: number, limit: string) =>
      new FurrowError({
        code: 'out-of-range',
        who,
        problem: `the mesh "${mesh.name ?? index}" has too many ${what}`,
        value,
        limit,
        remedy: 'decimate it (the maps keep the detail), or name another mesh with --mesh',
      })
    if (largest > MAX_SKIN_TRIANGLES) {
      const limit = `${MAX_SKIN_TRIANGLES.toLocaleString('en')} triangles of one material`
      throw fault('triangles', largest, limit)
    }
    if (largest * targets > mostMoved) {
      const limit = `${mostMoved.toLocaleString('en')} in a file of ${fileBytes.toLocaleString('en')} bytes`
      throw fault('triangles times blendshapes', largest * targets, limit)
    }
  }
}

/** Triangles with blendshapes, by index of their material. */
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
