import { writeFileSync } from 'node:fs'
import { Document, NodeIO } from '@gltf-transform/core'
import { accessorsOf } from '../../accessors.ts'

/** Flat square sheet of skin, as arrays that tests may change. */
export interface Sheet {
  positions: Float32Array<ArrayBuffer>
  uvs: Float32Array<ArrayBuffer> | undefined
  indices: Uint32Array<ArrayBuffer>
  targets: Record<string, Float32Array<ArrayBuffer>>
}

/** Width and height of the sheet, metres. */
const SIDE = 0.3

/** Fraction by which the middle of the sheet is shortened at weight 1. */
export const PUSHED = 0.25

/** Makes a sheet of n x n squares. Its blendshape `bend` compresses the middle third vertically. */
export function sheet(n = 40): Sheet {
  const count = (n + 1) ** 2
  const positions = new Float32Array(3 * count)
  const uvs = new Float32Array(2 * count)
  const bend = new Float32Array(3 * count)
  const indices = new Uint32Array(6 * n * n)
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const vertex = j * (n + 1) + i
      const [u, v] = [i / n, j / n]
      positions.set([SIDE * u, SIDE * (1 - v), 0], 3 * vertex)
      uvs.set([u, v], 2 * vertex)
      const isMiddle = u > 0.33 && u < 0.67
      const along = Math.min(Math.max(v - 0.5, -1 / 6), 1 / 6)
      bend[3 * vertex + 1] = isMiddle ? PUSHED * SIDE * along : 0
      if (i === n || j === n) continue
      const [a, b] = [vertex, vertex + n + 1]
      indices.set([a, b, b + 1, a, b + 1, a + 1], 6 * (j * n + i))
    }
  }
  return { positions, uvs, indices, targets: { bend } }
}

/** Makes a `.glb` from a sheet, with the mesh `torso` and one material. */
export async function sheetGlb({ positions, uvs, indices, targets }: Sheet): Promise<Uint8Array> {
  const document = new Document()
  const accessor = accessorsOf(document)
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', positions))
    .setAttribute('NORMAL', accessor('VEC3', towardsViewer(positions.length / 3)))
    .setIndices(accessor('SCALAR', indices))
    .setMaterial(document.createMaterial('cloth'))
  if (uvs) primitive.setAttribute('TEXCOORD_0', accessor('VEC2', uvs))
  for (const [name, offsets] of Object.entries(targets)) {
    primitive.addTarget(
      document.createPrimitiveTarget(name).setAttribute('POSITION', accessor('VEC3', offsets)),
    )
  }
  const mesh = document
    .createMesh('torso')
    .addPrimitive(primitive)
    .setExtras({ targetNames: Object.keys(targets) })
  document.createScene().addChild(document.createNode('body').setMesh(mesh))
  return new NodeIO().writeBinary(document)
}

function towardsViewer(count: number): Float32Array {
  return Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 2 ? 1 : 0))
}

/** Writes a sheet as `.glb`, after `spoil` has changed it. Returns the path. */
export async function writeSheet(path: string, spoil: (shape: Sheet) => void = () => {}, squares = 40) {
  const shape = sheet(squares)
  spoil(shape)
  writeFileSync(path, await sheetGlb(shape))
  return path
}
