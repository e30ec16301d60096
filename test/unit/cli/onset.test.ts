import { readFileSync } from 'node:fs'
import type { GrayImage, RgbaImage } from 'furrow'
import { parseWrinkleMaps } from 'furrow/internal'
import { readWrinkleMaps } from 'furrow/three'
import sharp from 'sharp'
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest'
import { noise } from '../../noise.ts'
import { loadInNode } from '../three/node-loader.ts'
import { OCCLUSION, SIZE, texels, writeSharedFolder } from './shared-image-folder.ts'
import { grayOf, Workshop, wrinklesIn } from './workshop.ts'

// Furrow reads the pixels of an ImageBitmap with WebGL, which Node lacks. In this test, the bitmap is an object with pixels.
vi.mock(import('../../../packages/furrow/src/runtime/file/read-image.ts'), async (original) => ({
  ...(await original()),
  readImage: (bitmap) => bitmap as unknown as RgbaImage,
}))

const shop = new Workshop()
const ONSET = (i: number) => 10 + (i % 118)
const layersOf = (path: string) => parseWrinkleMaps(wrinklesIn(path), 99).layers

/** Makes a folder with a layer that has occlusion and onset, and one that has only onset. */
const makeFolder = (name: string, more: object = {}) =>
  writeSharedFolder(shop, name, 'onset', ONSET, [
    { name: 'up', onsetStrength: 0.5, ...more },
    { name: 'down' },
  ])

const out = shop.path('packed.glb')
let folder = ''

beforeAll(async () => {
  folder = await makeFolder('folder')
  await shop.run('pack', folder, '-o', out)
})

afterAll(() => vi.unstubAllGlobals())

describe('the onset map of a folder', () => {
  it('is packed into the image of the occlusion', () => {
    const [up, down] = layersOf(out)
    expect(up.onsetTexture).toEqual({ index: up.occlusionTexture!.index, strength: 0.5 })
    expect(down.onsetTexture).toMatchObject({ strength: 1 })
    expect(down).not.toHaveProperty('occlusionTexture')
  })

  it('survives unpack and pack', async () => {
    await shop.run('unpack', out, '-o', shop.path('again'))
    expect(await grayOf(shop.path('again/layers/up/onset.png'))).toEqual(texels.map(ONSET))
    expect(await grayOf(shop.path('again/layers/up/occlusion.png'))).toEqual(texels.map(OCCLUSION))
    expect(await grayOf(shop.path('again/layers/down/onset.png'))).toEqual(texels.map(ONSET))
    const { layers } = JSON.parse(readFileSync(shop.path('again/wrinkles.json'), 'utf8'))
    expect(layers[0]).toMatchObject({ onset: 'layers/up/onset.png', onsetStrength: 0.5 })
    expect(layers[1]).not.toHaveProperty('onsetStrength')
    await shop.run('pack', shop.path('again'), '-o', shop.path('twice.glb'))
    expect(readFileSync(shop.path('twice.glb')).equals(readFileSync(out))).toBe(true)
  })

  it('is read by the loader', async () => {
    const [found] = await readWrinkleMaps(await loadInNode(readFileSync(out)))
    const [up, down] = found.set.layers
    expect(up.onsetStrength).toBe(0.5)
    for (const { onset } of [up, down]) expect([...(onset as GrayImage).data]).toEqual(texels.map(ONSET))
    expect([...(up.occlusion as GrayImage).data]).toEqual(texels.map(OCCLUSION))
  })

  it('leaves roughness in its image, if roughness and occlusion share one', async () => {
    const orm = await makeFolder('orm', { roughness: 'layers/up/occlusion.png' })
    const painted = await noise(5, 3, SIZE)
    shop.write('orm/layers/up/occlusion.png', painted)
    await shop.run('pack', orm, '-o', shop.path('orm.glb'))
    const [up] = layersOf(shop.path('orm.glb'))
    expect(up.onsetTexture!.index).toBe(up.occlusionTexture!.index)
    expect(up.roughnessTexture!.index).not.toBe(up.occlusionTexture!.index)
    const [found] = await readWrinkleMaps(await loadInNode(readFileSync(shop.path('orm.glb'))))
    const [{ roughness, occlusion, onset }] = found.set.layers
    const pixels = await sharp(painted).raw().toBuffer()
    const channel = (at: number) => texels.map((i) => pixels[3 * i + at])
    expect([...(roughness as GrayImage).data]).toEqual(channel(1))
    expect([...(occlusion as GrayImage).data]).toEqual(channel(0))
    expect([...(onset as GrayImage).data]).toEqual(texels.map(ONSET))
  })

  it("becomes a channel of the occlusion's KTX 2 array", async () => {
    await shop.run('pack', folder, '-o', shop.path('ktx2.glb'), '--ktx2')
    const layers = layersOf(shop.path('ktx2.glb'))
    const { index } = layers[0].occlusionTexture!
    expect(layers.map(({ onsetTexture }) => onsetTexture)).toEqual([
      { index, slice: 0, strength: 0.5 },
      { index, slice: 1, strength: 1 },
    ])
  })

  it('is inspected as a separate map, and is valid', async () => {
    await shop.run('inspect', out, '--sheet', shop.path('sheet.png'), '--json')
    const [up] = JSON.parse(shop.printed).layers
    expect(up.maps.map(({ map }: { map: string }) => map)).toEqual(['normal', 'occlusion', 'onset'])
    await shop.run('validate', out)
    expect(shop.printed).toContain('0 errors, 0 warnings')
  })
})
