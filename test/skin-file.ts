import { type Accessor, Document, NodeIO } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { Matrix4, Quaternion, Vector3 } from 'three'

export interface SkinFileOptions {
  mesh: string
  material: string
  /** Rotations about the x axis, radians, that an animation gives a joint. */
  animation?: { joint: string; angles: readonly number[] }
  /** Whether the whole model lies on its back, as if the file's upward axis was Z. */
  isLying?: boolean
}

/** Writes a skin with its skeleton as a `.glb` file. */
export async function skinFile(
  { positions, uvs, indices, skeleton }: Skin,
  { mesh: meshName, material: materialName, animation, isLying = false }: SkinFileOptions,
): Promise<Uint8Array> {
  const document = new Document()
  const buffer = document.createBuffer()
  const accessor = (type: Parameters<Accessor['setType']>[0], array: Parameters<Accessor['setArray']>[0]) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer)
  const { joints, influences, ...own } = skeleton!
  const count = positions.length / 3
  const four = (values: ArrayLike<number>) =>
    Array.from({ length: 4 * count }, (_, i) =>
      i % 4 < influences ? values[(i >> 2) * influences + (i % 4)]! : 0,
    )
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
    .setAttribute('NORMAL', accessor('VEC3', normalsOf(positions, indices)))
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
    .setAttribute('JOINTS_0', accessor('VEC4', Uint8Array.from(four(own.indices))))
    .setAttribute('WEIGHTS_0', accessor('VEC4', Float32Array.from(four(own.weights))))
    .setIndices(accessor('SCALAR', Uint32Array.from(indices)))
    .setMaterial(document.createMaterial(materialName).setRoughnessFactor(0.8).setMetallicFactor(0))
  const mesh = document.createMesh(meshName).addPrimitive(primitive)
  const binds = joints.map(({ bind }) => new Matrix4().fromArray(Array.from(bind)))
  const nodes = joints.map(({ name, parent }, i) => {
    const local = parent < 0 ? binds[i]! : binds[parent]!.clone().invert().multiply(binds[i]!)
    const [place, rotation, size] = [new Vector3(), new Quaternion(), new Vector3()]
    local.decompose(place, rotation, size)
    return document
      .createNode(name)
      .setTranslation([place.x, place.y, place.z])
      .setRotation([rotation.x, rotation.y, rotation.z, rotation.w])
  })
  const root = document.createNode('Armature')
  if (isLying) root.setRotation([Math.SQRT1_2, 0, 0, Math.SQRT1_2])
  for (const [i, node] of nodes.entries()) (nodes[joints[i]!.parent] ?? root).addChild(node)
  const inverses = binds.flatMap((bind) => bind.clone().invert().toArray())
  const skin = document.createSkin().setInverseBindMatrices(accessor('MAT4', Float32Array.from(inverses)))
  for (const node of nodes) skin.addJoint(node)
  root.addChild(document.createNode(meshName).setMesh(mesh).setSkin(skin))
  document.createScene().addChild(root)
  if (animation) {
    const turned = animation.angles.flatMap((angle) => [Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)])
    const sampler = document
      .createAnimationSampler()
      .setInput(
        accessor(
          'SCALAR',
          Float32Array.from(animation.angles, (_, i) => i),
        ),
      )
      .setOutput(accessor('VEC4', Float32Array.from(turned)))
    const target = nodes[joints.findIndex(({ name }) => name === animation.joint)]!
    const channel = document
      .createAnimationChannel()
      .setSampler(sampler)
      .setTargetNode(target)
      .setTargetPath('rotation')
    document.createAnimation('move').addSampler(sampler).addChannel(channel)
  }
  return new NodeIO().writeBinary(document)
}

function normalsOf(positions: ArrayLike<number>, indices: ArrayLike<number>): Float32Array {
  const normals = new Float32Array(positions.length)
  const at = (i: number) => new Vector3(positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!)
  for (let t = 0; t < indices.length; t += 3) {
    const corners = [indices[t]!, indices[t + 1]!, indices[t + 2]!]
    const [a, b, c] = corners.map(at) as [Vector3, Vector3, Vector3]
    const normal = b.sub(a).cross(c.sub(a))
    for (const corner of corners)
      for (const [k, value] of normal.toArray().entries()) normals[3 * corner + k]! += value
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) || 1
    for (let k = 0; k < 3; k++) normals[i + k]! /= length
  }
  return normals
}
