import { type Accessor, Document, WebIO } from '@gltf-transform/core'
import { KHRMaterialsUnlit, KHRMeshQuantization } from '@gltf-transform/extensions'
import { sheet } from '../../unit/author/auto/sheet.ts'

/** Number of squares per row and per column. */
const N = 24
/** Half the width of the sheet, metres. */
export const HALF = 0.04

/** Makes a file without wrinkles: a flat sheet, centred on the origin, with a blendshape that shortens it. */
export async function bareSheet(
  edit: (document: Document) => void = () => {},
): Promise<Uint8Array<ArrayBuffer>> {
  const document = new Document()
  const { positions, uvs, indices, offsets } = sheet(N, 30)
  const buffer = document.createBuffer()
  const accessor = (
    type: 'VEC2' | 'VEC3' | 'SCALAR',
    array: Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer>,
  ) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer)
  const metres = (values: number[]) => Float32Array.from(values, (millimetres) => millimetres / 1000)
  const target = document
    .createPrimitiveTarget('squash')
    .setAttribute('POSITION', accessor('VEC3', metres(offsets)))
  const corners = metres(positions).map((value, i) => (i % 3 < 2 ? value - HALF : value))
  const material = document.createMaterial('skin').setRoughnessFactor(0.6).setMetallicFactor(0)
  const primitive = document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(accessor('SCALAR', Uint16Array.from(indices)))
    .setAttribute('POSITION', accessor('VEC3', corners))
    .setAttribute(
      'NORMAL',
      accessor(
        'VEC3',
        corners.map((_, i) => (i % 3 === 2 ? 1 : 0)),
      ),
    )
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
    .addTarget(target)
  const mesh = document
    .createMesh('sheet')
    .addPrimitive(primitive)
    .setExtras({ targetNames: ['squash'] })
    .setWeights([0])
  document.createScene().addChild(document.createNode('sheet').setMesh(mesh))
  edit(document)
  const bytes = await new WebIO()
    .registerExtensions([KHRMaterialsUnlit, KHRMeshQuantization])
    .writeBinary(document)
  return bytes as Uint8Array<ArrayBuffer>
}

/** Moves the names of blendshapes to the extras of the primitive, where some exporters write them. */
export function moveNames(document: Document): void {
  const [mesh] = document.getRoot().listMeshes()
  mesh!.listPrimitives()[0]!.setExtras(mesh!.getExtras())
  mesh!.setExtras({})
}

/** Stores positions, offsets and texture coordinates in 16 bits, interleaved as gltfpack does. */
export function quantise(document: Document): void {
  document.createExtension(KHRMeshQuantization).setRequired(true)
  const [primitive] = document.getRoot().listMeshes()[0]!.listPrimitives()
  const scale = 2 * HALF
  const inUnits = (attribute: Accessor) =>
    attribute
      .setArray(Int16Array.from(numbersOf(attribute), (value) => Math.round((value / scale) * 32767)))
      .setNormalized(true)
  inUnits(primitive!.getAttribute('POSITION')!)
  inUnits(primitive!.listTargets()[0]!.getAttribute('POSITION')!)
  const uvs = primitive!.getAttribute('TEXCOORD_0')!
  uvs.setArray(Uint16Array.from(numbersOf(uvs), (value) => Math.round(value * 65535))).setNormalized(true)
  document.getRoot().listNodes()[0]!.setScale([scale, scale, scale])
}

/** Splits the triangles between two primitives. Each keeps all vertices. */
export function splitInTwo(document: Document): void {
  const [mesh] = document.getRoot().listMeshes()
  const [first] = mesh!.listPrimitives()
  const second = first!.clone()
  mesh!.addPrimitive(second)
  const indices = first!.getIndices()!
  const half = indices.getCount() / 2
  const part = (start: number) => indices.clone().setArray(indices.getArray()!.slice(start, start + half))
  first!.setIndices(part(0))
  second.setIndices(part(half))
}

export function withoutIndex(document: Document): void {
  const [primitive] = document.getRoot().listMeshes()[0]!.listPrimitives()
  const indices = numbersOf(primitive!.getIndices()!)
  const expand = (attribute: Accessor) => {
    const size = attribute.getElementSize()
    const values = numbersOf(attribute)
    const all = indices.map((vertex) => values.slice(size * vertex, size * (vertex + 1)))
    attribute.setArray(Float32Array.from(all.flat()))
  }
  primitive!.setIndices(null)
  for (const attribute of primitive!.listAttributes()) expand(attribute)
  expand(primitive!.listTargets()[0]!.getAttribute('POSITION')!)
}

/** Converts the sheet to centimetres. Its node scales it back to metres, and turns it upside down. */
export function scaleNode(document: Document): void {
  const [primitive] = document.getRoot().listMeshes()[0]!.listPrimitives()
  for (const attribute of [
    primitive!.getAttribute('POSITION')!,
    primitive!.listTargets()[0]!.getAttribute('POSITION')!,
  ]) {
    attribute.setArray(Float32Array.from(numbersOf(attribute), (value) => 100 * value))
  }
  document.getRoot().listNodes()[0]!.setScale([0.01, 0.01, 0.01]).setRotation([0, 0, 1, 0])
}

export function makeUnlit(document: Document): void {
  const unlit = document.createExtension(KHRMaterialsUnlit).createUnlit()
  document.getRoot().listMaterials()[0]!.setExtension(KHRMaterialsUnlit.EXTENSION_NAME, unlit)
}

export function withoutTargets(document: Document): void {
  const [mesh] = document.getRoot().listMeshes()
  const [primitive] = mesh!.setWeights([]).setExtras({}).listPrimitives()
  primitive!.removeTarget(primitive!.listTargets()[0]!)
}

export function stillTarget(document: Document): void {
  const [primitive] = document.getRoot().listMeshes()[0]!.listPrimitives()
  const offsets = primitive!.listTargets()[0]!.getAttribute('POSITION')!
  offsets.setArray(new Float32Array(offsets.getArray()!.length))
}

/** Adds a second node that shows the same mesh. */
export function showTwice(document: Document): void {
  const [mesh] = document.getRoot().listMeshes()
  document.getRoot().listScenes()[0]!.addChild(document.createNode('twin').setMesh(mesh!))
}

function numbersOf(attribute: Accessor): number[] {
  return [...attribute.getArray()!]
}
