import { surfaceOf } from 'furrow/internal/three'
import { type LoadedWrinkles, readWrinkleMaps } from 'furrow/three'
import type { Mesh, Object3D } from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

/** Face in a loaded glTF file. */
export interface Face {
  /** Scene of the file, with skin, eyes, teeth and lashes. */
  root: Object3D
  /** Mesh that has wrinkles in the file, or that callers can give wrinkles. */
  skin: Mesh
  /** Other primitives of the skin's glTF mesh that have the skin's material. GLTFLoader makes a mesh from each of them. */
  parts: Mesh[]
  /** Wrinkles that the file stores for `skin`, or null. */
  wrinkles: Pick<LoadedWrinkles, 'set' | 'drivers'> | null
}

/** Name by which the skin is found in files without wrinkles. */
const SKIN = 'skin'

/**
 * Loads a face from a glTF file, with the wrinkles that the file stores.
 *
 * @param skin name of the mesh to wrinkle. Default: the first mesh with wrinkles, otherwise the mesh named `skin`, otherwise the mesh
 *   with the most vertices.
 * @param loader loader with all decoders that the file needs. `loadFace` adds the meshopt decoder.
 * @throws Error if the file has no mesh, or the named mesh is missing.
 */
export async function loadFace(url: string, skin?: string, loader = new GLTFLoader()): Promise<Face> {
  const gltf = await loader.setMeshoptDecoder(MeshoptDecoder).loadAsync(url)
  const { scene: root } = gltf
  const meshes: Mesh[] = []
  root.traverse((object) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh)
  })
  const loaded = await readWrinkleMaps(gltf)
  const found = chooseSkin(meshes, loaded, skin)
  if (!found) {
    const names = meshes.map(({ name }) => name).join(', ') || 'none'
    throw new Error(
      `face: unknown mesh, got ${JSON.stringify(skin ?? SKIN)}, allowed: ${names}; use one of these names`,
    )
  }
  const indexOf = (mesh: Mesh) => gltf.parser.associations.get(mesh)?.meshes
  const parts = meshes.filter(
    (mesh) =>
      mesh !== found &&
      mesh.parent === found.parent &&
      surfaceOf(mesh) === surfaceOf(found) &&
      indexOf(mesh) === indexOf(found),
  )
  const wrinkles = loaded.find(({ meshes }) => meshes.includes(found)) ?? null
  return { root, skin: found, parts, wrinkles }
}

function chooseSkin(meshes: Mesh[], loaded: LoadedWrinkles[], skin?: string): Mesh | undefined {
  if (skin !== undefined) return meshes.find(({ name }) => name === skin)
  return loaded[0]?.meshes[0] ?? meshes.find(({ name }) => name === SKIN) ?? largest(meshes)
}

function largest(meshes: Mesh[]): Mesh | undefined {
  const size = (mesh: Mesh) => mesh.geometry.getAttribute('position').count
  return meshes.reduce<Mesh | undefined>(
    (best, mesh) => (best && size(best) >= size(mesh) ? best : mesh),
    undefined,
  )
}
