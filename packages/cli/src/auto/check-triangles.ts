import { FurrowError } from 'furrow'
import { MOST_TRIANGLES } from 'furrow/author'
import type { Glb, GltfMesh } from '../wrinkles/glb-file.ts'

const TRIANGLES = 4

/**
 * Refuses by the file's own numbers what is too large to be worked on, before any of it is decoded.
 *
 * @param meshName only this mesh, or that of a node of this name.
 * @throws FurrowError naming the mesh.
 */
export function checkTriangles({ json }: Glb, who: string, meshName?: string): void {
  const { meshes = [], nodes = [], accessors = [] } = json
  const countOf = (accessor = -1) => (accessors[accessor] as { count?: number } | undefined)?.count ?? 0
  for (const [index, mesh] of meshes.entries()) {
    const names = [mesh.name, ...nodes.filter((node) => node.mesh === index).map(({ name }) => name)]
    if (meshName !== undefined && !names.includes(meshName)) continue
    const most = Math.max(0, ...trianglesByMaterial(mesh, countOf).values())
    if (most <= MOST_TRIANGLES) continue
    throw new FurrowError({
      who,
      what: `the mesh "${mesh.name ?? index}" has too many triangles`,
      value: most,
      limit: `${MOST_TRIANGLES.toLocaleString('en')} triangles of one material`,
      remedy: 'decimate it, the maps hold the detail; or name another mesh with --mesh',
    })
  }
}

/** Triangles that blendshapes move. */
function trianglesByMaterial(
  { primitives }: GltfMesh,
  countOf: (accessor?: number) => number,
): Map<number | undefined, number> {
  const sums = new Map<number | undefined, number>()
  for (const { mode = TRIANGLES, targets = [], indices, attributes, material } of primitives) {
    if (mode !== TRIANGLES || targets.length === 0) continue
    const count = Math.floor(countOf(indices ?? attributes?.POSITION) / 3)
    sums.set(material, (sums.get(material) ?? 0) + count)
  }
  return sums
}
