import type { BufferAttribute, Mesh, Object3D, SkinnedMesh } from 'three'

/** Detects changes of the pose of a face. The pose consists of blendshape weights and offsets, joints, and the transforms of meshes. */
export class PoseWatch {
  readonly #meshes: readonly Mesh[]
  #pose: number[] = []

  constructor(meshes: readonly Mesh[]) {
    this.#meshes = meshes
  }

  /** Returns whether the pose has changed since the last call. The first call returns true. */
  hasChanged(): boolean {
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
      // If the user edits a virtual muscle, the offsets of its blendshape change.
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
