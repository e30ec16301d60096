import { type Bone, Matrix4, type Mesh, type Object3D, PropertyBinding, type SkinnedMesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import { JointMeasurement, MATRIX } from '../../drivers/bone/measure.ts'
import { measuredSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { rootOf } from '../mesh/root-of.ts'

/** Measures joints relative to their rest pose, see `restPoses`. */
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
      // A cloned skinned mesh gets its skeleton after its creation.
      if (joints.length === 0 || (mesh as SkinnedMesh).skeleton !== skeleton) {
        skeleton = (mesh as SkinnedMesh).skeleton
        joints = names.map((name) => findJoint(mesh, name)!)
      }
      for (let i = 0; i < joints.length; i++) {
        // `set` with a plain array allocates.
        const { elements } = joints[i].matrixWorld
        for (let k = 0; k < MATRIX; k++) matrices[MATRIX * i + k] = elements[k]
      }
      measurement.measure(matrices, values)
    },
  }
}

/** Finds a node by its name in the file, as written or as sanitized by `GLTFLoader`. */
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
 * Returns the rest pose per input: the bind pose if both joints are bones of the mesh's skeleton, independent of the pose when loaded.
 * Otherwise the current pose.
 *
 * @returns a function from an input to the packed world matrices of all joints.
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
