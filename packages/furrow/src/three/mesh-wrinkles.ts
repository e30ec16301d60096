import type { Mesh } from 'three'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

const wrinklesByMesh = new WeakMap<Mesh, WrinkleFaces>()

/** Returns the wrinkles first added to a mesh, or undefined. */
export function wrinklesOfMesh(mesh: Mesh): WrinkleFaces | undefined {
  return wrinklesByMesh.get(mesh)
}

/** Registers the wrinkles of a mesh. Returns a function that unregisters them. */
export function registerWrinkles(mesh: Mesh, wrinkles: WrinkleFaces): () => void {
  if (!wrinklesOfMesh(mesh)) wrinklesByMesh.set(mesh, wrinkles)
  return () => {
    if (wrinklesOfMesh(mesh) === wrinkles) wrinklesByMesh.delete(mesh)
  }
}
