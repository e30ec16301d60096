import type { Mesh, Object3D } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

export interface Face {
  /** Everything in the file: skin, eyes, teeth, lashes. */
  root: Object3D
  /** The mesh that wrinkles. */
  skin: Mesh
}

/** Name of the mesh that wrinkles, where a file does not say. */
const SKIN = 'skin'

/**
 * Loads a face.
 *
 * @param skin name of the mesh that wrinkles; `skin` unless told, and the mesh with most vertices if none has it.
 * @throws Error when the file has no mesh, or none of that name.
 */
export async function loadFace(url: string, skin?: string): Promise<Face> {
  const { scene: root } = await new GLTFLoader().loadAsync(url)
  const meshes: Mesh[] = []
  root.traverse((object) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh)
  })
  const found = meshes.find(({ name }) => name === (skin ?? SKIN)) ?? (skin ? undefined : largest(meshes))
  if (!found) {
    const names = meshes.map(({ name }) => name).join(', ') || 'none'
    throw new Error(
      `face: no mesh to wrinkle, got ${JSON.stringify(skin ?? SKIN)}, allowed: ${names}; name one of them`,
    )
  }
  return { root, skin: found }
}

function largest(meshes: Mesh[]): Mesh | undefined {
  const size = (mesh: Mesh) => mesh.geometry.getAttribute('position').count
  return meshes.reduce<Mesh | undefined>(
    (best, mesh) => (best && size(best) >= size(mesh) ? best : mesh),
    undefined,
  )
}
