import type { Mesh } from 'three'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

const wrinklesByMesh = new WeakMap<Mesh, WrinkleFaces>()

/** The wrinkles that were added to a mesh, or undefined; if there are several, the first. */
export function addedTo(mesh: Mesh): WrinkleFaces | undefined {
  return wrinklesByMesh.get(mesh)
}

/** Notes that wrinkles were added to a mesh. Returns what ends that. */
export function noteAdded(mesh: Mesh, wrinkles: WrinkleFaces): () => void {
  if (!addedTo(mesh)) wrinklesByMesh.set(mesh, wrinkles)
  return () => {
    if (addedTo(mesh) === wrinkles) wrinklesByMesh.delete(mesh)
  }
}
