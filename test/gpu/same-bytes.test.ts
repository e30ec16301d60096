import { expect, it } from 'vitest'
import { autoDigest } from '../auto-digest.ts'

it.each([
  ['human.glb', '/faces/human.glb'],
  ['small-head.glb', '/small-head.glb'],
] as const)('automatic wrinkles of %s are the same bits in this browser as in Node', async (name, url) => {
  const [file, inNode] = await Promise.all([fetch(url), fetch('/auto-digests.json')])
  const digest = await autoDigest(name, new Uint8Array(await file.arrayBuffer()))
  expect(digest).toEqual((await inNode.json())[name])
})
