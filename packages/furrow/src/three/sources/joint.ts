import { type Bone, Matrix4, type Mesh, type Object3D, PropertyBinding, type SkinnedMesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import { JointMeasurement, MATRIX } from '../../drivers/bone/measure.ts'
import { measuredSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { rootOf } from '../mesh/root-of.ts'

/** Creates a reader of joint inputs: rotations relative to the rest pose (in radians), and distances between two joints (in metres). */
export function bindJoints(mesh: Mesh, inputs: readonly InputOf<'joint'>[]): InputReader<unknown> {
  const all = [...new Set(inputs.flatMap(({ from, joint }) => [from, joint]))]
  const names = all.filter((name) => findJoint(mesh, name))
  const measurement = new JointMeasurement(inputs, names, restPoses(mesh, names))
  const matrices = new Float64Array(MATRIX * names.length)
  let joints: Object3D[] = []
  let skeleton: unknown
  return {
    ...measuredSource(measurement.missing),
    read(values) {
      // `SkeletonUtils.clone` gives a copied mesh its skeleton after the mesh is created.
      if (joints.length === 0 || (mesh as SkinnedMesh).skeleton !== skeleton) {
        skeleton = (mesh as SkinnedMesh).skeleton
        joints = names.map((name) => findJoint(mesh, name)!)
      }
      for (let i = 0; i < joints.length; i++) {
        // A loop, because `TypedArray.set` allocates if its argument is an array of numbers.
        const { elements } = joints[i].matrixWorld
        for (let k = 0; k < MATRIX; k++) matrices[MATRIX * i + k] = elements[k]
      }
      measurement.measure(matrices, values)
    },
  }
}

/** Finds a joint by its name in the file. `GLTFLoader` may have sanitized the name. Prefers bones of the mesh's skeleton. */
function findJoint(mesh: Mesh, name: string): Object3D | undefined {
  const isNamed = (object: Object3D) =>
    object.name === name || object.name === PropertyBinding.sanitizeNodeName(name)
  const bone = (mesh as SkinnedMesh).skeleton?.bones.find(isNamed)
  if (bone) return bone
  let found: Object3D | undefined
  rootOf(mesh).traverse((object) => {
    if (!found && isNamed(object)) found = object
  })
  return found
}

/**
 * Finds the rest pose of each input. If both joints of the input are bones of the mesh's skeleton, their bind pose is the rest pose. Otherwise
 * the current pose is the rest pose.
 *
 * @returns a function that returns, for an input, the packed world matrices of all joints in the rest pose.
 */
function restPoses(mesh: Mesh, names: readonly string[]): (input: InputOf<'joint'>) => Float64Array {
  const { skeleton } = mesh as Partial<SkinnedMesh>
  const [bound, current] = [new Float64Array(MATRIX * names.length), new Float64Array(MATRIX * names.length)]
  const isBone = names.map((name, i) => {
    const joint = findJoint(mesh, name)!
    joint.updateWorldMatrix(true, false)
    current.set(joint.matrixWorld.elements, MATRIX * i)
    const inverse = skeleton?.boneInverses[skeleton.bones.indexOf(joint as Bone)]
    if (inverse) bound.set(new Matrix4().copy(inverse).invert().elements, MATRIX * i)
    return inverse !== undefined
  })
  return ({ from, joint }) => (isBone[names.indexOf(from)] && isBone[names.indexOf(joint)] ? bound : current)
}
