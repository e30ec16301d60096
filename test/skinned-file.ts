import { Document } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { BufferAttribute, BufferGeometry, Matrix4 } from 'three'
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js'
import { accessorsOf } from './accessors.ts'

/** Mesh of a file: a skin with a plain material. */
export interface SkinnedPart {
  /** Name of the mesh and of its node. */
  name: string
  material: {
    name: string
    colour: readonly [r: number, g: number, b: number]
    metalness?: number
    roughness?: number
  }
  skin: Skin
}

/** Returns a document with meshes that share the skeleton of the first part. */
export function skinnedFile(parts: readonly SkinnedPart[]): Document {
  const document = new Document()
  const accessor = accessorsOf(document)
  const scene = document.createScene()
  const { joints } = parts[0]!.skin.skeleton!
  const binds = joints.map(({ bind }) => new Matrix4().fromArray(Array.from(bind)))
  const nodes = joints.map(({ name }) => document.createNode(name))
  const skin = document.createSkin()
  for (const [i, { parent }] of joints.entries()) {
    const local = parent < 0 ? binds[i]! : binds[parent]!.clone().invert().multiply(binds[i]!)
    nodes[i]!.setMatrix(local.toArray())
    ;(nodes[parent] ?? scene).addChild(nodes[i]!)
    skin.addJoint(nodes[i]!)
  }
  const inverses = binds.flatMap((bind) => bind.clone().invert().toArray())
  skin.setInverseBindMatrices(accessor('MAT4', Float32Array.from(inverses)))
  for (const {
    name,
    material,
    skin: { positions, uvs, indices, skeleton },
  } of parts) {
    const { colour, metalness = 0, roughness = 0.8 } = material
    const { influences, ...own } = skeleton!
    const count = positions.length / 3
    const four = (values: ArrayLike<number>) =>
      Array.from({ length: 4 * count }, (_, i) =>
        i % 4 < influences ? values[influences * (i >> 2) + (i % 4)]! : 0,
      )
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
      .setAttribute('NORMAL', accessor('VEC3', normalsOf(positions, indices)))
      .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
      .setAttribute('JOINTS_0', accessor('VEC4', Uint8Array.from(four(own.indices))))
      .setAttribute('WEIGHTS_0', accessor('VEC4', Float32Array.from(four(own.weights))))
      .setIndices(accessor('SCALAR', Uint32Array.from(indices)))
      .setMaterial(
        document
          .createMaterial(material.name)
          .setBaseColorFactor([...colour, 1])
          .setMetallicFactor(metalness)
          .setRoughnessFactor(roughness)
          .setDoubleSided(true),
      )
    const mesh = document.createMesh(name).addPrimitive(primitive)
    scene.addChild(document.createNode(name).setMesh(mesh).setSkin(skin))
  }
  return document
}

/** Returns smooth normals, equal for vertices at one position. */
function normalsOf(positions: ArrayLike<number>, indices: ArrayLike<number>): Float32Array {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3))
  geometry.setIndex(Array.from(indices))
  const merged = mergeVertices(geometry, 1e-6)
  merged.computeVertexNormals()
  const normals = merged.getAttribute('normal')
  const out = new Float32Array(positions.length)
  for (const [corner, vertex] of Array.from(indices).entries())
    for (let k = 0; k < 3; k++) out[3 * vertex + k] = normals.getComponent(merged.index!.getX(corner), k)
  return out
}
