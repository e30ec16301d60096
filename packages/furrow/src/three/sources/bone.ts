import { type Bone, Matrix4, type Mesh, type Object3D, PropertyBinding, type SkinnedMesh } from 'three'
import { BoneActivation, MATRIX } from '../../drivers/bone.ts'
import { driversOf } from '../../drivers/types.ts'
import type { SourceType } from './source.ts'

/**
 * Reads joints: the bones of the mesh's skeleton at rest as they were bound, or other nodes of the model, at rest as they are
 * when the drivers are added.
 */
export const boneSource: SourceType = {
  types: ['bone'],
  create({ mesh }, drivers) {
    const own = driversOf('bone', drivers)
    const names = [...new Set(own.flatMap(({ joints }) => joints))].filter((name) => findJoint(mesh, name))
    const driver = new BoneActivation(own, names, restMatrices(mesh, names))
    const matrices = new Float64Array(MATRIX * names.length)
    let joints: Object3D[] = []
    let skeleton: unknown
    return {
      driver,
      update() {
        // A copy of a skinned mesh gets its own skeleton only after it was made.
        if (joints.length === 0 || (mesh as SkinnedMesh).skeleton !== skeleton) {
          skeleton = (mesh as SkinnedMesh).skeleton
          joints = names.map((name) => findJoint(mesh, name)!)
        }
        for (let i = 0; i < joints.length; i++) {
          // One by one: `set` of a plain array allocates.
          const { elements } = joints[i].matrixWorld
          for (let k = 0; k < MATRIX; k++) matrices[MATRIX * i + k] = elements[k]
        }
        driver.update(matrices)
      },
    }
  },
}

/** By the name in the file, or what `GLTFLoader` makes of it. */
function findJoint(mesh: Mesh, name: string): Object3D | undefined {
  const named = (object: Object3D) =>
    object.name === name || object.name === PropertyBinding.sanitizeNodeName(name)
  const bone = (mesh as SkinnedMesh).skeleton?.bones.find(named)
  if (bone) return bone
  let root: Object3D = mesh
  while (root.parent) root = root.parent
  let found: Object3D | undefined
  root.traverse((object) => {
    if (!found && named(object)) found = object
  })
  return found
}

/** Those of the skeleton where all joints are in it, so that whatever pose the model was loaded in does not matter. */
function restMatrices(mesh: Mesh, names: readonly string[]): Float64Array {
  const joints = names.map((name) => findJoint(mesh, name)!)
  const { skeleton } = mesh as Partial<SkinnedMesh>
  const bound = joints.map((joint) => skeleton?.boneInverses[skeleton.bones.indexOf(joint as Bone)])
  const isBound = bound.every((inverse) => inverse)
  const rest = new Float64Array(MATRIX * names.length)
  for (const [i, joint] of joints.entries()) {
    if (!isBound) joint.updateWorldMatrix(true, false)
    const matrix = isBound ? new Matrix4().copy(bound[i]!).invert() : joint.matrixWorld
    rest.set(matrix.elements, MATRIX * i)
  }
  return rest
}
