import { Document, WebIO } from '@gltf-transform/core'
import { KHRMaterialsUnlit, KHRMeshQuantization } from '@gltf-transform/extensions'
import { sheet } from '../unit/author/auto/sheet.ts'

/** Squares per side. */
const N = 24
/** Half of its side in metres. */
export const HALF = 0.04

/** A file with a flat sheet round the origin, which a blendshape shortens, and no wrinkles. */
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
