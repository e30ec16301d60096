import type { Mesh } from 'three'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

/** Wrinkles of each mesh, oldest first. A page that changes the mesh's material may add new wrinkles before it disposes of the old ones. */
const wrinklesByMesh = new WeakMap<Mesh, WrinkleFaces[]>()

/** Returns the oldest wrinkles of a mesh that are not disposed of, or undefined. */
export function wrinklesOfMesh(mesh: Mesh): WrinkleFaces | undefined {
  return wrinklesByMesh.get(mesh)?.[0]
}

/** Registers the wrinkles of a mesh. Returns a function that unregisters them. */
export function registerWrinkles(mesh: Mesh, wrinkles: WrinkleFaces): () => void {
  wrinklesByMesh.set(mesh, [...(wrinklesByMesh.get(mesh) ?? []), wrinkles])
  return () => {
    const others = wrinklesByMesh.get(mesh)?.filter((other) => other !== wrinkles) ?? []
    wrinklesByMesh.set(mesh, others)
  }
}
