import { NodeIO } from '@gltf-transform/core'
import { KHRDracoMeshCompression } from '@gltf-transform/extensions'
import { draco } from '@gltf-transform/functions'
import draco3d from 'draco3d'
import { describe, expect, it } from 'vitest'
import { dracoProblem } from '../../../packages/files/src/checks/draco.ts'
import { joinGlb, splitGlb } from '../../fuzz/glb-parts.ts'
import { sheet, sheetGlb } from './sheet.ts'
import { Workshop } from './workshop.ts'

const shop = new Workshop()

/** Makes a mesh compressed with Draco. It has no blendshapes, because Draco cannot compress them. */
async function compressed(method: 'sequential' | 'edgebreaker'): Promise<Buffer> {
  const io = new NodeIO()
    .registerExtensions([KHRDracoMeshCompression])
    .registerDependencies({ 'draco3d.encoder': await draco3d.createEncoderModule() })
  const document = await io.readBinary(await sheetGlb({ ...sheet(12), targets: {} }))
  await document.transform(draco({ method }))
  return Buffer.from(await io.writeBinary(document))
}

/** Replaces the number at an offset in the header of the Draco data. Numbers there have a variable length. */
async function withCount(method: 'sequential' | 'edgebreaker', at: number, count: number): Promise<Buffer> {
  const { json, bin } = splitGlb(await compressed(method))
  const start = bin.indexOf('DRACO')
  const old = bin[start + at]! < 128 ? 1 : 2
  const varint: number[] = []
  for (; count > 127; count = Math.floor(count / 128)) varint.push((count % 128) | 128)
  const rest = bin.subarray(start + at + old)
  const changed = Buffer.concat([bin.subarray(start, start + at), Buffer.of(...varint, count), rest])
  const offset = Math.ceil(bin.length / 4) * 4
  const { KHR_draco_mesh_compression: extension } = json.meshes[0].primitives[0].extensions
  extension.bufferView =
    json.bufferViews.push({ buffer: 0, byteOffset: offset, byteLength: changed.length }) - 1
  json.buffers[0].byteLength = offset + changed.length
  return joinGlb({ json, bin: Buffer.concat([bin, Buffer.alloc(offset - bin.length), changed]) })
}

const problemOf = (glb: Buffer) => {
  const { json, bin } = splitGlb(glb)
  return dracoProblem(json, bin)
}

describe('meshes in Draco', () => {
  it.each(['sequential', 'edgebreaker'] as const)('are decoded as encoded: %s', async (method) => {
    expect(problemOf(await compressed(method))).toBeUndefined()
  })

  // The mesh has 13 x 13 vertices and 288 triangles.
  it.each<[string, 'sequential' | 'edgebreaker', number, RegExp]>([
    [
      '2 million vertices',
      'sequential',
      13,
      /meshes\[0\] has 2000000 vertices in its Draco data, but its accessors declare 169/,
    ],
    [
      '2 million triangles',
      'sequential',
      11,
      /meshes\[0\] has 6000000 indices in its Draco data, but its accessors declare 864/,
    ],
    [
      '2 million triangles',
      'edgebreaker',
      14,
      /meshes\[0\] has 6000000 indices in its Draco data, but its accessors declare 864/,
    ],
  ])('are not decoded if they claim %s: %s', async (_, method, at, message) => {
    const path = shop.write('hostile.glb', await withCount(method, at, 2_000_000))
    const error = await shop.failure('auto', path, '-o', shop.path('out.glb'))
    expect(error.name).toBe('FurrowError')
    expect(error.message).toMatch(message)
  })

  it('are not decoded in another version or with metadata', async () => {
    for (const [at, value] of [
      [5, 1],
      [10, 0x80],
    ]) {
      const glb = await compressed('edgebreaker')
      glb[glb.indexOf('DRACO') + at!] = value!
      expect(problemOf(glb)).toMatch(/that glTF does not allow/)
    }
  })
})
