import {
  Bone,
  Box3,
  BufferAttribute,
  BufferGeometry,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { expect, test } from 'vitest'
import { createReliefMesh } from '../../../packages/furrow/src/three/relief/relief-mesh.ts'

/** Metres per unit of quantised positions. */
const SCALE = 0.1

/** Triangle with integer positions that stand for -1..1, as in quantised files. */
function quantised(): BufferGeometry {
  const geometry = new BufferGeometry()
  const positions = Int16Array.of(-32767, -32767, 0, 32767, -32767, 0, 0, 32767, 32767)
  geometry.setAttribute('position', new BufferAttribute(positions, 3, true))
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(12), 4))
  geometry.setAttribute('skinWeight', new Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], 4))
  return geometry
}

/** Geometry with more vertices than the mesh, in the same unit. */
function dense(geometry: BufferGeometry): BufferGeometry {
  const { array } = geometry.attributes.position!
  const positions = Float32Array.from([...array, ...array], (value) => value / 32767)
  return new BufferGeometry().setAttribute('position', new BufferAttribute(positions, 3))
}

function skinned(): Mesh {
  const mesh = new SkinnedMesh(quantised(), new MeshStandardMaterial())
  const bone = new Bone()
  mesh.add(bone)
  // The inverse bind matrix converts quantised positions to metres.
  mesh.bind(new Skeleton([bone], [new Matrix4().makeScale(SCALE, SCALE, SCALE)]), new Matrix4())
  return mesh
}

function scaled(): Mesh {
  const mesh = new Mesh(quantised(), new MeshStandardMaterial())
  mesh.scale.setScalar(SCALE)
  return mesh
}

function instanced(): Mesh {
  const mesh = new InstancedMesh(quantised(), new MeshStandardMaterial(), 2)
  for (const i of [0, 1]) mesh.setMatrixAt(i, new Matrix4().makeTranslation(5 * i, 0, 0))
  mesh.scale.setScalar(SCALE)
  return mesh
}

test.each([
  ['a skinned mesh', skinned],
  ['a mesh that its node scales', scaled],
  ['an instanced mesh', instanced],
])('relief keeps the bounds of %s', (_, create) => {
  const mesh = create()
  mesh.updateMatrixWorld(true)
  const boxes = () => [false, true].map((isPrecise) => new Box3().setFromObject(mesh, isPrecise))
  const before = boxes()
  const relief = createReliefMesh(mesh, dense(mesh.geometry), mesh.material as MeshStandardMaterial)
  relief.matrixWorld = mesh.matrixWorld
  mesh.add(relief)
  expect(boxes()).toEqual(before)
  expect(before[0]!.max.y).toBeCloseTo(SCALE)
})
