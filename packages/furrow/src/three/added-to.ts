import type { Mesh } from 'three'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import type { AnyRenderer } from './renderer.ts'

const wrinklesByMesh = new WeakMap<Mesh, WrinkleFaces<AnyRenderer>>()

/** The wrinkles that were added to a mesh, or undefined; if there are several, the first. */
export function addedTo(mesh: Mesh): WrinkleFaces<AnyRenderer> | undefined {
  return wrinklesByMesh.get(mesh)
}

/** Notes that wrinkles were added to a mesh. Returns what ends that. */
export function noteAdded(mesh: Mesh, wrinkles: WrinkleFaces<AnyRenderer>): () => void {
  if (!addedTo(mesh)) wrinklesByMesh.set(mesh, wrinkles)
  return () => {
    if (addedTo(mesh) === wrinkles) wrinklesByMesh.delete(mesh)
  }
}
