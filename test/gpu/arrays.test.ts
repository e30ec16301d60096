import { FurrowError } from 'furrow'
import { addArea, readWrinkleMaps, removeArea, updateArea, updateLayer, wrinklesOf } from 'furrow/three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest'
import { largestDifference } from './difference.ts'
import { HEIGHT, WIDTH } from './face.ts'
import { harnessOn, RENDERERS } from './harness.ts'
import { compareWrinkles, loadPacked, posedPicture, wrinklesAlone } from './packed.ts'

describe.each(RENDERERS)('maps in KTX 2 on %s', (name) => {
  const harness = harnessOn(name)
  let ktx2: KTX2Loader
  /** Results for the face with PNG images: its influence, and the difference that wrinkles make in the picture. */
  let images: { areaNames: readonly string[]; influence: Float32Array; alone: Float32Array }
  beforeAll(async () => {
    ktx2 = new KTX2Loader().setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
    ktx2.detectSupport(harness.renderer as never)
    images = await shown('images')
  })
  afterAll(() => {
    ktx2.dispose()
  })

  const load = (file: 'images' | 'arrays' | 'ktx2', loader = new GLTFLoader().setKTX2Loader(ktx2)) =>
    loadPacked(harness, file, loader)

  async function shown(file: 'images' | 'arrays' | 'ktx2') {
    const gltf = await load(file)
    const [wrinkles] = gltf.userData.wrinkles
    const { areaNames } = wrinkles
    const influence = await posedPicture(harness, gltf, 'influence')
    const alone = await wrinklesAlone(harness, gltf)
    wrinkles.dispose()
    return { areaNames, influence, alone }
  }

  it.each([
    ['in arrays', 'arrays'],
    ['as single images', 'ktx2'],
  ] as const)('show the same wrinkles, %s, as PNG images', async (_, file) => {
    const arrays = await shown(file)
    const largest = largestDifference(images.influence, arrays.influence)
    const mean =
      images.influence.reduce((sum, value, i) => sum + Math.abs(value - arrays.influence[i]), 0) /
      (4 * WIDTH * HEIGHT)
    expect(Math.max(...images.influence.filter((_, i) => i % 4 === 0))).toBeGreaterThan(0.9)
    // UASTC has 8 bits per texel for all four areas in the channels of a slice, so single texels can be wrong by 12%.
    expect(largest).toBeLessThan(0.12)
    expect(mean).toBeLessThan(0.004)
    const { strength, correlation, ratio } = compareWrinkles(images.alone, arrays.alone)
    expect(strength).toBeGreaterThan(1)
    expect(correlation).toBeGreaterThan(0.95)
    expect(Math.abs(ratio - 1)).toBeLessThan(0.05)
    expect(arrays.areaNames).toEqual(images.areaNames)
  })

  it('ask for a KTX2Loader if the page has set none', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const gltf = await load('arrays', new GLTFLoader())
    expect(warn.mock.calls).toEqual([[expect.stringMatching(/setKTX2Loader.* is shown without wrinkles/)]])
    expect(wrinklesOf(gltf)).toEqual([])
    await expect(readWrinkleMaps(gltf)).rejects.toThrow(FurrowError)
    warn.mockRestore()
  })

  it("refuse the paper's mode; areas can be removed, but no images added or changed", async () => {
    const gltf = await load('arrays')
    const [wrinkles] = gltf.userData.wrinkles
    expect(() => {
      wrinkles.mode = 'paper'
    }).toThrow(/does not support compressed maps/)
    expect(wrinkles.mode).toBe('default')
    const weights = { width: 4, height: 4, data: new Uint8Array(16) }
    expect(() => addArea(wrinkles, { name: 'more', weights })).toThrow(/in different texture arrays/)
    expect(() => updateArea(wrinkles, 'nose', weights)).toThrow(
      /^updateArea area "nose": textures of KTX 2 files/,
    )
    const normal = { width: 4, height: 4, data: new Uint8Array(64) }
    expect(() => updateLayer(wrinkles, 'expression', { normal })).toThrow(
      /textures of KTX 2 files.*PNG or WebP/,
    )
    removeArea(wrinkles, 'nose')
    expect(wrinkles.areaNames).not.toContain('nose')
    await posedPicture(harness, gltf, 'default')
    wrinkles.dispose()
  })
})
