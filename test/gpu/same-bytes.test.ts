import { expect, it } from 'vitest'
import { autoDigest } from './auto-digest.ts'

it('automatic wrinkles are the same bits in this browser as in Node', async () => {
  const [file, inNode] = await Promise.all([fetch('/faces/human.glb'), fetch('/auto-digest.json')])
  const digest = await autoDigest(new Uint8Array(await file.arrayBuffer()))
  expect(Object.keys(digest)).toContain('areas')
  expect(digest).toEqual(await inNode.json())
})
