import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { documentOf, findSurfaces } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { expect, test } from 'vitest'
import { Workshop } from './workshop.ts'

const HAND = fileURLToPath(new URL('../../../faces/hand.glb', import.meta.url))
const at = new Workshop()

interface Channel {
  target: { node?: number; path: string; extensions?: object }
}

/** Returns the number of rotations of each joint that the animations of a file show. */
async function rotationsIn(path: string) {
  const document = await documentOf(await readGlbFile(path, 'test', {}), path, 'test')
  const { joints } = findSurfaces(document, path, 'test', {}).surfaces[0]!.skin.skeleton!
  return joints.map(({ name, rotations }) => [name, Array.from(rotations ?? [])] as const)
}

test('rotations that an animation names by a pointer count like others', async () => {
  const bytes = readFileSync(HAND)
  const length = bytes.readUInt32LE(12)
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString())
  for (const { channels } of json.animations as { channels: Channel[] }[])
    for (const { target } of channels) {
      target.extensions = { KHR_animation_pointer: { pointer: `/nodes/${target.node}/rotation` } }
      target.path = 'pointer'
      delete target.node
    }
  json.extensionsUsed.push('KHR_animation_pointer')
  const text = Buffer.from(JSON.stringify(json))
  const padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')])
  const head = Buffer.from(bytes.subarray(0, 20))
  head.writeUInt32LE(20 + padded.length + bytes.length - 20 - length, 8)
  head.writeUInt32LE(padded.length, 12)
  const path = at.write('pointers.glb', Buffer.concat([head, padded, bytes.subarray(20 + length)]))
  const expected = await rotationsIn(HAND)
  expect(expected.filter(([, rotations]) => rotations.length > 0).length).toBeGreaterThan(10)
  expect(await rotationsIn(path)).toEqual(expected)
})
