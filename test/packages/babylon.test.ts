// Tests Babylon.js apps in strict TypeScript, built by Vite with the packed `furrow`.

import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { DEPENDENCIES } from './npm.ts'
import { expectFaceThatChanges } from './pressed-app.ts'
import { type ServedApp, serveApp } from './served-app.ts'

describe.each([
  ['the newest Babylon.js', DEPENDENCIES.babylon],
  ['Babylon.js 8.0', DEPENDENCIES.oldestBabylon],
])('an app in %s', (_, packages) => {
  let served: ServedApp
  beforeAll(async () => {
    served = await serveApp('babylon', packages)
  })
  afterAll(() => served?.close())

  it.each([
    ['WebGL 2', ''],
    ['WebGPU', 'webgpu'],
  ])('shows a surprised face on %s with and without wrinkles, from its own files alone', async (_, way) =>
    expect(await expectFaceThatChanges(served, way)).toEqual([]),
  )
})
