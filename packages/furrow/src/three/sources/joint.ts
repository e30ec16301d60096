import { type Bone, Matrix4, type Mesh, type Object3D, PropertyBinding, type SkinnedMesh } from 'three'
import { JointMeasurement, MATRIX } from '../../drivers/bone/measure.ts'
import { measuredSource } from '../../drivers/sources.ts'
import type { BindInputs } from './binding.ts'

/**
 * Measures joints: bones of the mesh's skeleton against the bind pose, or other nodes of the model against their pose when the drivers
 * are added.
 */
export const bindJoints: BindInputs<'joint'> = ({ mesh }, inputs) => {
  const all = [...new Set(inputs.flatMap(({ from, joint }) => [from, joint]))]
  const names = all.filter((name) => findJoint(mesh, name))
  const measurement = new JointMeasurement(inputs, names, restMatrices(mesh, names))
  const matrices = new Float64Array(MATRIX * names.length)
  let joints: Object3D[] = []
  let skeleton: unknown
  return {
    ...measuredSource(measurement.missing),
    read(values) {
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
      measurement.measure(matrices, values)
    },
  }
}

/** By the name in the file, or what `GLTFLoader` makes of it. */
function findJoint(mesh: Mesh, name: string): Object3D | undefined {
  const isNamed = (object: Object3D) =>
    object.name === name || object.name === PropertyBinding.sanitizeNodeName(name)
  const bone = (mesh as SkinnedMesh).skeleton?.bones.find(isNamed)
  if (bone) return bone
  let root: Object3D = mesh
  while (root.parent) root = root.parent
  let found: Object3D | undefined
  root.traverse((object) => {
    if (!found && isNamed(object)) found = object
  })
  return found
}

/** The bind pose where all joints are in the skeleton, so that the pose the model was loaded in does not matter. */
function restMatrices(mesh: Mesh, names: readonly string[]): Float64Array {
  const joints = names.map((name) => findJoint(mesh, name)!)
  const { skeleton } = mesh as Partial<SkinnedMesh>
  const inverses = joints.map((joint) => skeleton?.boneInverses[skeleton.bones.indexOf(joint as Bone)])
  const isBound = inverses.every((inverse) => inverse)
  const rest = new Float64Array(MATRIX * names.length)
  for (const [i, joint] of joints.entries()) {
    if (!isBound) joint.updateWorldMatrix(true, false)
    const matrix = isBound ? new Matrix4().copy(inverses[i]!).invert() : joint.matrixWorld
    rest.set(matrix.elements, MATRIX * i)
  }
  return rest
}
