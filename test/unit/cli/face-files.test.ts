import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { GltfJson } from 'furrow-files'
import { expect, it } from 'vitest'
import { faceFiles } from '../../../packages/cli/src/face-outputs.ts'
import type { BufferView } from '../../../packages/files/src/json/gltf-json.ts'

const BYTES = Uint8Array.from({ length: 100 }, (_, i) => i)

/** Writes a file as `.gltf`, and its image, the first buffer view, as a separate file. Returns the remaining views and the buffer. */
async function written(...views: Omit<BufferView, 'buffer'>[]) {
  const bufferViews = views.map((view) => ({ buffer: 0, ...view }))
  const json: GltfJson = {
    buffers: [{ byteLength: BYTES.length }],
    bufferViews,
    images: [{ bufferView: 0, mimeType: 'image/png' }],
  }
  const glb = { json, bin: Buffer.from(BYTES), bytes: BYTES, references: new Map(), fileBytes: BYTES.length }
  const files = await faceFiles(glb, join(tmpdir(), 'furrow-none', 'out.gltf'), 'furrow auto')
  const find = (end: string) => files.find(({ path }) => path.endsWith(end))!.bytes
  const bin = find('.bin')
  const moved: BufferView[] = JSON.parse(Buffer.from(find('.gltf')).toString()).bufferViews
  const contents = moved.map(({ byteOffset = 0, byteLength }) => [
    ...bin.subarray(byteOffset, byteOffset + byteLength),
  ])
  return { bin, moved, contents }
}

const range = (start: number, end: number) => [...BYTES.subarray(start, end)]

it('closes the gap of a removed image, and keeps the alignment of views', async () => {
  const { bin, moved, contents } = await written(
    { byteOffset: 20, byteLength: 21 },
    { byteOffset: 44, byteLength: 8 },
    { byteLength: 18 },
    { byteOffset: 62, byteLength: 3 },
  )
  expect(contents).toEqual([range(44, 52), range(0, 18), range(62, 65)])
  expect(moved.map(({ byteOffset = 0 }) => byteOffset % 4)).toEqual([0, 0, 2])
  expect(bin.length).toBeLessThan(40)
})

it('writes bytes shared by several views once', async () => {
  const many = Array.from({ length: 1000 }, (_, i) => ({ byteOffset: 40 + (i % 4), byteLength: 50 }))
  const { bin, contents } = await written({ byteLength: 40 }, ...many)
  expect(bin.length).toBe(53)
  expect(contents).toEqual(
    many.map(({ byteOffset, byteLength }) => range(byteOffset, byteOffset + byteLength)),
  )
})

it('keeps the offset of an empty view within the buffer', async () => {
  const { bin, moved } = await written(
    { byteLength: 40 },
    { byteOffset: 40, byteLength: 60 },
    { byteOffset: 100, byteLength: 0 },
  )
  expect(bin.length).toBe(60)
  expect(moved[1].byteOffset).toBeLessThan(60)
})
