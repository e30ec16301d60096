import { wrinklesOf, wrinklesReady } from 'furrow/three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { harnessOn, RENDERERS } from '../harness.ts'
import { litPicture, loadFile } from '../loaded.ts'
import { quietConsole } from '../quiet-console.ts'
import { wrinkledFile } from '../wrinkled-file.ts'
import { bareSheet } from './bare-sheet.ts'

describe.each(RENDERERS)('a browser with missing APIs, on %s', (name) => {
  const harness = harnessOn(name)
  const spies = quietConsole()
  afterEach(() => void vi.unstubAllGlobals())

  it('shows wrinkles without OffscreenCanvas', async () => {
    vi.stubGlobal('OffscreenCanvas', undefined)
    const gltf = await loadFile(harness, await wrinkledFile())
    await litPicture(harness, gltf.scene)
    expect(wrinklesOf(gltf)).toHaveLength(1)
    expect(spies.warn).not.toHaveBeenCalled()
  })

  it.each(['DecompressionStream', 'createImageBitmap'])(
    'shows a face without %s, with at most one warning',
    async (missing) => {
      vi.stubGlobal(missing, undefined)
      const gltf = await loadFile(harness, await wrinkledFile())
      const picture = await litPicture(harness, gltf.scene)
      expect(picture.some((value) => value > 0)).toBe(true)
      const warnings = spies.warn.mock.calls.map(String).filter((text) => text.includes('FURROW'))
      expect(warnings).toHaveLength(wrinklesOf(gltf).length === 1 ? 0 : 1)
    },
  )

  it('makes no automatic wrinkles without Worker, and logs one warning', async () => {
    vi.stubGlobal('Worker', undefined)
    const { Plugin } = harness
    const auto = { size: 256, areaSize: 32 }
    const loader = new GLTFLoader().register((parser) => new Plugin(parser, { auto }))
    const gltf = await loader.parseAsync((await bareSheet()).buffer, '')
    expect(await wrinklesReady(gltf)).toEqual([])
    const picture = await litPicture(harness, gltf.scene)
    expect(picture.some((value) => value > 0)).toBe(true)
    expect(spies.warn).toHaveBeenCalledOnce()
    expect(String(spies.warn.mock.lastCall)).toContain('worker')
  })
})
