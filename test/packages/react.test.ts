// An app in React Three Fiber, in strict TypeScript, built by Vite from the packed package.

import { afterAll, beforeAll, expect, it } from 'vitest'
import { DEPENDENCIES } from './npm.ts'
import { expectFaceThatChanges } from './pressed-app.ts'
import { type ServedApp, serveApp } from './served-app.ts'

let served: ServedApp

beforeAll(async () => {
  const { three, types, react } = DEPENDENCIES
  served = await serveApp('react', [three, types, ...react])
})
afterAll(() => served?.close())

it.each([
  ['of a hook', ''],
  ["of a component round drei's <Gltf>", 'gltf'],
  ['on WebGPURenderer', 'webgpu'],
])('shows a surprised face by properties %s, and follows them', async (_, way) => {
  expect(await expectFaceThatChanges(served, way)).toEqual([])
})
