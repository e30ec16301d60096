import { readFileSync } from 'node:fs'
import type { GrayImage, RgbaImage } from 'furrow'
import { parseWrinkleMaps } from 'furrow/internal'
import { readWrinkleMaps } from 'furrow/three'
import sharp from 'sharp'
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest'
import { jsonOf } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { loadInNode } from '../three/node-loader.ts'
import { gray, OCCLUSION, SIZE, texels, writeSharedFolder } from './shared-image-folder.ts'
import { grayOf, grayPng, Workshop, wrinklesIn } from './workshop.ts'

// Furrow reads the pixels of an ImageBitmap with WebGL, which Node lacks. In this test, the bitmap is an object with pixels.
vi.mock(import('../../../packages/furrow/src/runtime/file/read-image.ts'), async (original) => ({
  ...(await original()),
  readImage: (bitmap) => bitmap as unknown as RgbaImage,
}))

const shop = new Workshop()

const mapsOf = (path: string) => parseWrinkleMaps(wrinklesIn(path), 99)

/** Decodes a texture of a packed file. */
async function imageOf(path: string, texture: number) {
  const bytes = readFileSync(path)
  const { textures, images, bufferViews } = jsonOf(bytes)
  const { byteOffset, byteLength } = bufferViews[images[textures[texture].source].bufferView]
  const start = bytes.length - bytes.readUInt32LE(20 + bytes.readUInt32LE(12)) + byteOffset
  const image = sharp(bytes.subarray(start, start + byteLength))
  return { bytes: await image.raw().toBuffer(), ...(await image.metadata()) }
}

const BLOOD = (i: number) => (i % 3 === 0 ? 128 : i % 256)

/** Makes a wrinkle folder with two layers: one has blood and occlusion, the other only blood. */
const makeFolder = (name: string, more: object = {}) =>
  writeSharedFolder(shop, name, 'blood', BLOOD, [
    { name: 'up', bloodAmplitude: 0.25, occlusionStrength: 0.5, ...more },
    { name: 'down', bloodAmplitude: 0.5 },
  ])

const out = shop.path('packed.glb')
let folder = ''

beforeAll(async () => {
  folder = await makeFolder('folder')
  await shop.run('pack', folder, '-o', out)
})

afterAll(() => vi.unstubAllGlobals())

describe('the blood map of a folder', () => {
  it('is packed into the blue channel of the occlusion', async () => {
    const [up, down] = mapsOf(out).layers
    expect(up.bloodTexture).toMatchObject({ index: up.occlusionTexture!.index, amplitude: 0.25 })
    expect(down.bloodTexture).toMatchObject({ amplitude: 0.5 })
    expect(down).not.toHaveProperty('occlusionTexture')
    const image = await imageOf(out, up.bloodTexture!.index)
    expect(image.channels).toBe(3)
    for (const [i, at] of [0, 1, 7, 255].entries()) {
      expect([...image.bytes.subarray(3 * at, 3 * at + 3)], `${i}`).toEqual([OCCLUSION(at), 255, BLOOD(at)])
    }
    const alone = await imageOf(out, down.bloodTexture!.index)
    expect([...alone.bytes.subarray(3, 6)]).toEqual([255, 255, BLOOD(1)])
  })

  it('is unpacked as a gray image next to the occlusion', async () => {
    await shop.run('unpack', out, '-o', shop.path('again'))
    expect(await grayOf(shop.path('again/layers/up/blood.png'))).toEqual(texels.map(BLOOD))
    expect(await grayOf(shop.path('again/layers/up/occlusion.png'))).toEqual(texels.map(OCCLUSION))
    expect((await sharp(shop.path('again/layers/up/blood.png')).metadata()).channels).toBe(1)
    const { layers } = JSON.parse(readFileSync(shop.path('again/wrinkles.json'), 'utf8'))
    expect(layers[0]).toMatchObject({ blood: 'layers/up/blood.png', bloodAmplitude: 0.25 })
    expect(layers[1]).not.toHaveProperty('occlusion')
    await shop.run('pack', shop.path('again'), '-o', shop.path('twice.glb'))
    expect(readFileSync(shop.path('twice.glb')).equals(readFileSync(out))).toBe(true)
  })

  it('may have 16 bits, with 32768 as neutral', async () => {
    const deep = await makeFolder('deep')
    const values = [32768, 0, 65535, 33025]
    shop.write(
      'deep/layers/down/blood.png',
      await grayPng(
        Uint16Array.from(texels, (i) => values[i % 4]),
        SIZE,
      ),
    )
    await shop.run('pack', deep, '-o', shop.path('deep.glb'))
    const { bytes } = await imageOf(
      shop.path('deep.glb'),
      mapsOf(shop.path('deep.glb')).layers[1].bloodTexture!.index,
    )
    expect([0, 1, 2, 3].map((i) => bytes[3 * i + 2])).toEqual([128, 0, 255, 129])
  })

  it('is scaled to the size of the occlusion', async () => {
    const small = await makeFolder('small')
    shop.write('small/layers/up/blood.png', await gray((i) => (i < 32 ? 128 : 200), 8))
    await shop.run('pack', small, '-o', shop.path('small.glb'))
    const { bytes, width } = await imageOf(
      shop.path('small.glb'),
      mapsOf(shop.path('small.glb')).layers[0].bloodTexture!.index,
    )
    expect(width).toBe(SIZE)
    expect([bytes[3 * 16 + 2], bytes[3 * (SIZE * SIZE - 1) + 2], bytes[3 * 16]]).toEqual([
      128,
      200,
      OCCLUSION(16),
    ])
  })

  it('keeps roughness in the image that roughness and occlusion share', async () => {
    const orm = await makeFolder('orm', { roughness: 'layers/up/occlusion.png' })
    shop.write('orm/layers/up/occlusion.png', await noise(5, 3, SIZE))
    await shop.run('pack', orm, '-o', shop.path('orm.glb'))
    const [up] = mapsOf(shop.path('orm.glb')).layers
    expect(up.roughnessTexture!.index).toBe(up.bloodTexture!.index)
    const { bytes } = await imageOf(shop.path('orm.glb'), up.bloodTexture!.index)
    const painted = await sharp(shop.path('orm/layers/up/occlusion.png')).raw().toBuffer()
    expect([...bytes.subarray(6, 9)]).toEqual([painted[6], painted[7], BLOOD(2)])
  })

  it("becomes a channel of the occlusion's KTX 2 array", async () => {
    await shop.run('pack', folder, '-o', shop.path('ktx2.glb'), '--ktx2')
    const { layers } = mapsOf(shop.path('ktx2.glb'))
    const { index } = layers[0].occlusionTexture!
    expect(layers.map(({ bloodTexture }) => bloodTexture)).toEqual([
      { index, slice: 0, amplitude: 0.25 },
      { index, slice: 1, amplitude: 0.5 },
    ])
    await shop.run('unpack', shop.path('ktx2.glb'), '-o', shop.path('ktx2'))
    const blood = await grayOf(shop.path('ktx2/layers/down/blood.png'))
    expect(Math.abs(blood[34] - BLOOD(34))).toBeLessThan(40)
  })

  it('is read by the loader', async () => {
    const [found] = await readWrinkleMaps(await loadInNode(readFileSync(out)))
    const [up, down] = found.set.layers
    expect(up.bloodAmplitude).toBe(0.25)
    expect([...(up.blood as GrayImage).data]).toEqual(texels.map(BLOOD))
    expect([...(up.occlusion as GrayImage).data]).toEqual(texels.map(OCCLUSION))
    expect(down).toMatchObject({ bloodAmplitude: 0.5, blood: up.blood })
    expect(down).not.toHaveProperty('occlusion')
  })

  it('is inspected as a separate map without a size, because it shares the image of the occlusion', async () => {
    await shop.run('inspect', out, '--sheet', shop.path('sheet.png'), '--json')
    const { layers, gpu } = JSON.parse(shop.printed)
    const [up] = layers
    const maps = Object.fromEntries(
      up.maps.map((map: { map: string; texture: number }) => [map.map, map.texture]),
    )
    expect(maps.blood).toBe(maps.occlusion)
    // Two normal maps and two images with blood, each 16 x 16 with mipmaps, and one area of 128 x 128.
    expect(gpu.uncompressed).toBe(4 * 4 * (256 + 64 + 16 + 4 + 1) - 4 * 4 * 341 + 3 * 4 * 341 + 128 * 128)
    expect((await sharp(shop.path('sheet.png')).metadata()).width).toBeGreaterThan(256)
  })

  it('is valid', async () => {
    await shop.run('validate', out)
    expect(shop.printed).toContain('0 errors, 0 warnings')
    expect(process.exitCode ?? 0).toBe(0)
  })
})

describe('pack refuses', () => {
  it.each([
    [
      'blood of another size than an occlusion that is not square',
      async (at: string) => {
        const wide = sharp({ create: { width: 32, height: 16, channels: 3, background: '#fff' } })
        shop.write(`${at}/layers/up/occlusion.png`, await wide.png().toBuffer())
      },
      /blood map of layer "up" differs in size from the map that shares its image/,
    ],
    [
      'blood without an amplitude, whose file lies there',
      async (at: string) => shop.json(`${at}/wrinkles.json`, { layers: [{ name: 'up' }] }),
      /layers\/up\/blood\.png requires bloodAmplitude, which its layer in wrinkles\.json lacks, allowed: 0 to 2; add it to "layers" in wrinkles\.json, e\.g\. \{"name":"up","bloodAmplitude":0\.3\}, or move the map out of the folder$/,
    ],
    [
      'a damaged image',
      async (at: string) => shop.write(`${at}/layers/up/blood.png`, (await gray(BLOOD)).subarray(0, 60)),
      /blood\.png/,
    ],
  ])('%s', async (what, spoil, message) => {
    const name = what.replaceAll(' ', '-')
    const spoilt = await makeFolder(name)
    await spoil(name)
    await shop.fails(message, 'pack', spoilt, '-o', shop.path('no.glb'))
  })
})
