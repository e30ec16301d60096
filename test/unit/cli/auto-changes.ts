import type { Document, Mesh, Node, Primitive } from '@gltf-transform/core'
import { KHRMeshQuantization, KHRTextureTransform } from '@gltf-transform/extensions'
import { meshopt, quantize, sparse } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer/encoder'
import { Matrix3, Vector2 } from 'three'
import { mapAttribute, meshOf, targetNamesOf } from './auto-variants.ts'

/** Functions that store the shipped face in another way, without changing its shape or position. docs/auto-formats.md lists them. */
export const FORMATS = {
  'named with _L and _R, behind a prefix': prefix,
  'with visemes and shapes of its own': addShapes,
  dense,
  sparse: (document: Document) => document.transform(dense, sparse({ ratio: 1 })),
  quantised: (document: Document) => document.transform(quantize()),
  meshopt: async (document: Document) => {
    await MeshoptEncoder.ready
    return document.transform(meshopt({ encoder: MeshoptEncoder, level: 'medium' }))
  },
  'in two primitives of one material': split,
  'placed by its node': placeByNode,
  'placed by a skeleton': placeBySkeleton,
  'with a KHR_texture_transform': transformCoordinates,
  'without a normal map, with integer coordinates that the transform of the base colour scales':
    quantiseCoordinates,
} as const satisfies Record<string, (document: Document) => unknown>

export function skinOf(document: Document): Mesh {
  return meshOf(document, 'skin')
}

/** Returns primitives, each followed by its targets. */
export function withTargets(primitives: readonly Primitive[]) {
  return primitives.flatMap((one) => [one, ...one.listTargets()])
}

/** Renames the blendshapes of a mesh. */
export function rename(mesh: Mesh, change: (name: string) => string): void {
  mesh.setExtras({ ...mesh.getExtras(), targetNames: targetNamesOf(mesh).map(change) })
}

/** Renames blendshapes as many exporters do: with a prefix, `_L` and `_R`. */
function prefix(document: Document): void {
  rename(skinOf(document), (name) => `head.${name.replace(/Left$/, '_L').replace(/Right$/, '_R')}`)
}

/** Stores blendshapes in dense instead of sparse accessors. */
function dense(document: Document): void {
  for (const accessor of document.getRoot().listAccessors()) accessor.setSparse(false)
}

/** Adds visemes (sums of other blendshapes), a blendshape with a meaningless name, and one that moves nothing. */
function addShapes(document: Document): void {
  const mesh = skinOf(document)
  const names = targetNamesOf(mesh)
  const primitive = mesh.listPrimitives()[0]!
  const targets = primitive.listTargets()
  const buffer = document.getRoot().listBuffers()[0]!
  const add = (name: string, sum: Readonly<Record<string, number>>) => {
    const first = primitive.getAttribute('POSITION')!
    const values = new Float32Array(3 * first.getCount())
    for (const [shape, weight] of Object.entries(sum)) {
      const moved = targets[names.indexOf(shape)]!.getAttribute('POSITION')!
      const element: number[] = []
      for (let i = 0; i < moved.getCount(); i++) {
        moved.getElement(i, element)
        for (let k = 0; k < 3; k++) values[3 * i + k]! += weight * element[k]!
      }
    }
    const accessor = document.createAccessor().setType('VEC3').setArray(values).setBuffer(buffer)
    primitive.addTarget(document.createPrimitiveTarget(name).setAttribute('POSITION', accessor))
    mesh.setExtras({ ...mesh.getExtras(), targetNames: [...targetNamesOf(mesh), name] })
  }
  add('viseme_aa', { jawOpen: 0.6, mouthFunnel: 0.1 })
  add('viseme_PP', { mouthClose: 0.3, mouthPressLeft: 0.5, mouthPressRight: 0.5 })
  add('viseme_O', { mouthFunnel: 0.7, jawOpen: 0.2 })
  add('Key 57', { jawForward: 0.5 })
  add('unused', {})
  mesh.setWeights([])
}

/** Gives the normal map a texture transform, and changes the texture coordinates so that the transform restores the old ones. */
export function transformCoordinates(document: Document): void {
  const [scale, rotation, offset] = [2, 0.7, [0.3, -0.6]] as const
  const mesh = skinOf(document)
  const info = mesh.listPrimitives()[0]!.getMaterial()!.getNormalTextureInfo()!
  const transform = document.createExtension(KHRTextureTransform).createTransform()
  transform
    .setScale([scale, scale])
    .setRotation(rotation)
    .setOffset([...offset])
  info.setExtension('KHR_texture_transform', transform)
  const back = new Matrix3().setUvTransform(...offset, scale, scale, rotation, 0, 0).invert()
  mapAttribute(mesh.listPrimitives(), 'TEXCOORD_0', ([u, v]) =>
    new Vector2(u!, v!).applyMatrix3(back).toArray(),
  )
}

/** Stores texture coordinates as 12-bit integers, as gltfpack does. Only the base colour has a transform that scales them back. */
export function quantiseCoordinates(document: Document): void {
  const [primitive] = skinOf(document).listPrimitives()
  const material = primitive!.getMaterial()!.setNormalTexture(null)
  const uv = primitive!.getAttribute('TEXCOORD_0')!
  const values = Uint16Array.from(uv.getArray() as Float32Array, (value) => Math.round(value * 4095))
  primitive!.setAttribute('TEXCOORD_0', document.createAccessor().setType('VEC2').setArray(values))
  document.createExtension(KHRMeshQuantization).setRequired(true)
  const transform = document.createExtension(KHRTextureTransform).createTransform()
  material
    .getBaseColorTextureInfo()!
    .setExtension(KHRTextureTransform.EXTENSION_NAME, transform.setScale([1 / 4095, 1 / 4095]))
}

/** Moves every other triangle to a second primitive. */
function split(document: Document): void {
  const mesh = skinOf(document)
  const first = mesh.listPrimitives()[0]!
  const corners = [...first.getIndices()!.getArray()!]
  const second = first.clone()
  for (const [half, primitive] of [first, second].entries()) {
    const own = corners.filter((_, i) => Math.floor(i / 3) % 2 === half)
    const indices = document.createAccessor().setType('SCALAR').setArray(Uint32Array.from(own))
    primitive.setIndices(indices.setBuffer(document.getRoot().listBuffers()[0]!))
  }
  mesh.addPrimitive(second)
}

/** Converts the skin to centimetres, rotates and moves it. The transform of its node compensates this. */
function placeByNode(document: Document): void {
  const mesh = skinOf(document)
  const node = nodeOf(mesh)
  mapAttribute(
    mesh.listPrimitives().flatMap((one) => one.listTargets()),
    'POSITION',
    ([x, y, z]) => [100 * x!, -100 * z!, 100 * y!],
  )
  mapAttribute(mesh.listPrimitives(), 'POSITION', ([x, y, z]) => [100 * x! + 7, -100 * z!, 100 * y! - 20])
  node
    .setScale([0.01, 0.01, 0.01])
    .setRotation([-Math.SQRT1_2, 0, 0, Math.SQRT1_2])
    .setTranslation([-0.07, 0.2, 0])
}

/** Converts the skin to centimetres. The inverse bind matrix of its only joint compensates this. Also moves the mesh's node, which glTF ignores. */
export function placeBySkeleton(document: Document): void {
  const mesh = skinOf(document)
  const node = nodeOf(mesh)
  mapAttribute(withTargets(mesh.listPrimitives()), 'POSITION', ([x, y, z]) => [100 * x!, 100 * y!, 100 * z!])
  const buffer = document.getRoot().listBuffers()[0]!
  const joint = document.createNode('head').setTranslation([0, 1.5, 0])
  document.getRoot().listScenes()[0]!.addChild(joint)
  const inverse = [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, 0.01, 0, 0, -1.5, 0, 1]
  const matrices = document
    .createAccessor()
    .setType('MAT4')
    .setArray(Float32Array.from(inverse))
    .setBuffer(buffer)
  node
    .setSkin(document.createSkin().addJoint(joint).setInverseBindMatrices(matrices))
    .setTranslation([3, 0, 0])
  for (const primitive of mesh.listPrimitives()) {
    const count = primitive.getAttribute('POSITION')!.getCount()
    const of = (array: Uint8Array | Float32Array) =>
      document.createAccessor().setType('VEC4').setArray(array).setBuffer(buffer)
    primitive.setAttribute('JOINTS_0', of(new Uint8Array(4 * count)))
    primitive.setAttribute(
      'WEIGHTS_0',
      of(Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))),
    )
  }
}

function nodeOf(mesh: Mesh): Node {
  return mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node
}
