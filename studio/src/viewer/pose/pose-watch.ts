import type { BufferAttribute, Mesh, Object3D, SkinnedMesh } from 'three'

/** Tells when the pose of a face is another one: its blendshapes, its joints, or where it stands. */
export class PoseWatch {
  readonly #meshes: readonly Mesh[]
  #pose: number[] = []

  constructor(meshes: readonly Mesh[]) {
    this.#meshes = meshes
  }

  /** Whether the pose is another one than at the last call; true at the first one. */
  isNew(): boolean {
    const pose = this.#read()
    const last = this.#pose
    if (pose.length === last.length && pose.every((value, i) => value === last[i])) return false
    this.#pose = pose
    return true
  }

  #read(): number[] {
    const pose: number[] = []
    for (const root of new Set(this.#meshes.map(rootOf))) root.updateMatrixWorld()
    for (const mesh of this.#meshes) {
      pose.push(...(mesh.morphTargetInfluences ?? []), ...mesh.matrixWorld.elements)
      // A muscle that pulls otherwise.
      for (const offsets of mesh.geometry.morphAttributes.position ?? [])
        pose.push((offsets as BufferAttribute).version ?? 0)
      const bones = (mesh as Partial<SkinnedMesh>).skeleton?.bones ?? []
      for (const { matrixWorld } of bones) pose.push(...matrixWorld.elements)
    }
    return pose
  }
}

function rootOf(object: Object3D): Object3D {
  let root = object
  while (root.parent) root = root.parent
  return root
}
