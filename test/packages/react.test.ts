// Tests React Three Fiber apps in strict TypeScript, built by Vite with the packed `furrow`.

import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { DEPENDENCIES } from './npm.ts'
import { expectFaceThatChanges } from './pressed-app.ts'
import { type ServedApp, serveApp } from './served-app.ts'

const { three, types, react, oldestThree, oldestReact } = DEPENDENCIES

const WEBGL = [
  ['of a hook', 'webgl'],
  ["of a component round drei's <Gltf>", 'gltf'],
]

describe.each([
  {
    name: 'React Three Fiber 9, React 19 and the newest three.js',
    packages: [three, types, ...react],
    ways: [...WEBGL, ['on WebGPURenderer', 'webgpu']],
    without: [],
  },
  {
    name: 'React Three Fiber 8, React 18 and the oldest three.js',
    packages: [...oldestThree, ...oldestReact],
    ways: WEBGL,
    without: ['ways/webgpu.tsx'],
  },
])('an app in $name', ({ packages, ways, without }) => {
  let served: ServedApp
  beforeAll(async () => {
    served = await serveApp('react', packages, without)
  })
  afterAll(() => served?.close())

  it.each(ways)('shows a surprised face set by properties %s, and follows their changes', async (_, way) => {
    expect(await expectFaceThatChanges(served, way!)).toEqual([])
  })
})
