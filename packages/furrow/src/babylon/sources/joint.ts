import type { Bone } from '@babylonjs/core/Bones/bone.js'
import { Matrix } from '@babylonjs/core/Maths/math.vector.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { TransformNode } from '@babylonjs/core/Meshes/transformNode.js'
import type { InputOf } from '../../drivers/activation.ts'
import { JointMeasurement, MATRIX } from '../../drivers/bone/measure.ts'
import { measuredSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'

/** A joint is a bone of the mesh's skeleton, or any other node. */
interface Joint {
  bone: Bone | undefined
  /** Node whose transform the joint follows. Undefined if the bone has no node and is animated directly. */
  node: TransformNode | undefined
}

/**
 * Creates a reader that measures joints. The rest pose of an input is the bind pose if both of its joints are bones. Otherwise it is the
 * pose at the time of this call.
 */
export function bindJoints(mesh: AbstractMesh, inputs: readonly InputOf<'joint'>[]): InputReader<unknown> {
  const all = [...new Set(inputs.flatMap(({ from, joint }) => [from, joint]))]
  const joints = new Map(
    all.flatMap((name) => {
      const joint = findJoint(mesh, name)
      return joint ? [[name, joint] as const] : []
    }),
  )
  const names = [...joints.keys()]
  const found = [...joints.values()]
  const size = MATRIX * names.length
  const [bound, current] = [new Float64Array(size), new Float64Array(size)]
  for (const [i, joint] of found.entries()) {
    current.set(worldOf(joint, mesh).m, MATRIX * i)
    if (joint.bone) bound.set(Matrix.Invert(joint.bone.getAbsoluteInverseBindMatrix()).m, MATRIX * i)
  }
  const isBone = (name: string) => joints.get(name)?.bone !== undefined
  const measurement = new JointMeasurement(inputs, names, ({ from, joint }) =>
    isBone(from) && isBone(joint) ? bound : current,
  )
  const matrices = new Float64Array(size)
  return {
    ...measuredSource(measurement.missing),
    read(values) {
      for (let i = 0; i < found.length; i++) {
        const { m } = worldOf(found[i], mesh)
        for (let k = 0; k < MATRIX; k++) matrices[MATRIX * i + k] = m[k]
      }
      measurement.measure(matrices, values)
    },
  }
}

function findJoint(mesh: AbstractMesh, name: string): Joint | undefined {
  const bone = mesh.skeleton?.bones.find(
    (candidate) => candidate.name === name || candidate.getTransformNode()?.name === name,
  )
  if (bone) return { bone, node: bone.getTransformNode() ?? undefined }
  let root: AbstractMesh['parent'] = mesh
  while (root.parent) root = root.parent
  const node = [root, ...root.getDescendants(false)].find((candidate) => candidate.name === name)
  return node ? { bone: undefined, node: node as TransformNode } : undefined
}

function worldOf({ bone, node }: Joint, mesh: AbstractMesh): Matrix {
  return node
    ? node.computeWorldMatrix(true)
    : bone!.getAbsoluteMatrix().multiply(mesh.computeWorldMatrix(true))
}
