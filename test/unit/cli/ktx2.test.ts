import { readFileSync } from 'node:fs'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { dedup, prune, textureCompress } from '@gltf-transform/functions'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { jsonOf, withJson } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { AREAS, faceBytes, Workshop, wrinklesIn } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
const packed = shop.path('packed.glb')
let folder = ''

type Json = ReturnType<typeof jsonOf>

beforeAll(async () => {
  folder = await shop.makeFolder('face')
  await shop.run('pack', folder, '--ktx2', '-o', packed)
})

/** Changes the JSON of the packed file by `spoil`, and returns the codes and messages of the findings. */
async function findings(spoil: (json: Json, maps: Json) => void): Promise<string> {
  const bytes = readFileSync(packed)
  const json = jsonOf(bytes)
  spoil(json, json.materials[0].extensions[NAME])
  return shop.output('validate', shop.write('spoilt.glb', withJson(bytes, json)))
}

async function pixels(path: string): Promise<number[]> {
  return [...(await sharp(path).toColourspace('srgb').removeAlpha().raw().toBuffer())]
}

const furthest = (a: number[], b: number[]) =>
  a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i]!)), a.length - b.length)

describe('furrow pack --ktx2', () => {
  it('puts each kind of map into an array, and four areas into a slice', () => {
    const { layers, areas } = wrinklesIn(packed)
    expect(layers.map(({ normalTexture }: Json) => normalTexture.slice)).toEqual([0, 1])
    expect(new Set(layers.map(({ normalTexture }: Json) => normalTexture.index)).size).toBe(1)
    expect(layers[1].baseColorTexture.slice).toBe(0)
    expect(areas.map(({ texture, channel = 0 }: Json) => [texture.slice, channel])).toEqual(
      AREAS.map((_, i) => [Math.floor(i / 4), i % 4]),
    )
    const { extensionsUsed, extensionsRequired, textures, images } = jsonOf(readFileSync(packed))
    expect(extensionsUsed).toContain('KHR_texture_basisu')
    expect(extensionsRequired).toBeUndefined()
    const texture = textures[areas[0].texture.index]
    expect(texture.source).toBeUndefined()
    expect(images[texture.extensions.KHR_texture_basisu.source].mimeType).toBe('image/ktx2')
  })

  it('makes a valid file with the areas of the folder, except for compression loss', async () => {
    await shop.run('validate', packed)
    expect(shop.printed).toBe(`${packed}: 0 errors, 0 warnings\n`)
    const report = JSON.parse(await shop.output('inspect', packed, '--json'))
    // Areas: two slices of 128 x 128 with 8 bits per texel. Maps: three of 16 x 16, with 16 + 4 + 1 + 1 + 1 blocks of 16 bytes each.
    expect(report.gpu.bits8).toBe(2 * 128 * 128 + 3 * (16 + 4 + 1 + 1 + 1) * 16)
    expect(report.areas.map(({ name }: Json) => name)).toEqual(AREAS)
    const out = shop.path('unpacked')
    await shop.run('unpack', packed, '-o', out)
    for (const area of AREAS) {
      const [before, after] = [`${folder}/areas/${area}.png`, `${out}/areas/${area}.png`]
      expect(furthest(await pixels(before), await pixels(after)), area).toBeLessThan(40)
    }
  })

  it('makes the same JSON when a face is unpacked and packed again', async () => {
    const [first, again] = [shop.path('first'), shop.path('again.glb')]
    await shop.run('unpack', packed, '-o', first)
    await shop.run('pack', first, '--ktx2', '-o', again)
    expect(wrinklesIn(again)).toEqual(wrinklesIn(packed))
    const second = shop.path('second')
    await shop.run('unpack', again, '-o', second)
    const documents = ['first', 'second'].map((name) => shop.files(name)['wrinkles.json'])
    expect(documents[1]).toBe(documents[0])
    // The second encoding changes weights only slightly.
    for (const area of AREAS) {
      const [before, after] = [first, second].map((at) => `${at}/areas/${area}.png`)
      expect(furthest(await pixels(before), await pixels(after)), area).toBeLessThanOrEqual(6)
    }
  })

  it('leaves no data of its arrays in a face that is unpacked or packed again', async () => {
    const out = shop.path('bare')
    await shop.run('unpack', packed, '-o', out)
    expect(jsonOf(readFileSync(`${out}/face.glb`))).toEqual(jsonOf(await faceBytes()))
    await shop.run('pack', folder, '--face', packed, '--ktx2', '-o', shop.path('repacked.glb'))
    expect(readFileSync(shop.path('repacked.glb')).equals(readFileSync(packed))).toBe(true)
  })

  it('makes files that survive dedup, prune and conversion to WebP', async () => {
    const io = new NodeIO().registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    const document = await io.read(packed)
    await document.transform(dedup(), prune(), textureCompress({ encoder: sharp, targetFormat: 'webp' }))
    const path = shop.write('transformed.glb', await io.writeBinary(document))
    const [before, after] = [wrinklesIn(packed), wrinklesIn(path)]
    const slices = ({ layers, areas }: Json) => [
      ...layers.map(({ normalTexture }: Json) => normalTexture.slice),
      ...areas.map(({ texture }: Json) => texture.slice),
    ]
    expect(slices(after)).toEqual(slices(before))
    const [one, two] = [shop.path('one'), shop.path('two')]
    await shop.run('unpack', packed, '-o', one)
    await shop.run('unpack', path, '-o', two)
    for (const area of AREAS) {
      const file = `areas/${area}.png`
      expect(shop.files('two')[file], area).toBe(shop.files('one')[file])
    }
  })

  it('scales maps, and normals keep length 1', async () => {
    const out = shop.path('small.glb')
    await shop.run('pack', folder, '--size', '8', '-o', out)
    const small = shop.path('small')
    await shop.run('unpack', out, '-o', small)
    const normals = await pixels(`${small}/layers/age/normal.png`)
    expect(normals).toHaveLength(3 * 8 * 8)
    for (let i = 0; i < normals.length; i += 3) {
      const length = Math.hypot(...normals.slice(i, i + 3).map((value) => (value / 255) * 2 - 1))
      expect(Math.abs(length - 1)).toBeLessThan(0.01)
    }
  })

  it('refuses sizes without whole blocks, and names a remedy', async () => {
    const odd = await shop.makeFolder('odd')
    shop.write('odd/layers/age/normal.png', await noise(1, 3, 18))
    shop.write('odd/layers/expression/normal.png', await noise(2, 3, 18))
    const message = /got "18 x 18", allowed: multiples of 4 texels; .*--size/
    await shop.fails(message, 'pack', odd, '--ktx2', '-o', shop.path('odd.glb'))
  })
})

describe('furrow pack --ktx2 with unsupported input', () => {
  it('refuses more texels than the encoder supports', async () => {
    const big = await shop.makeFolder('big')
    const flat = sharp({ create: { width: 4096, height: 4096, channels: 3, background: '#8080ff' } })
    const normal = await flat.png().toBuffer()
    for (const layer of ['age', 'expression']) shop.write(`big/layers/${layer}/normal.png`, normal)
    const message = /^furrow pack: too many texels .*got "2 x 4096 x 4096".*--size/
    await shop.fails(message, 'pack', big, '--ktx2', '-o', shop.path('big.glb'))
  })

  it('refuses the option --share, because arrays share in another way', async () => {
    const args = [folder, '--ktx2', '--share', '1', '-o', shop.path('shared.glb')]
    await shop.fails("option '--ktx2' cannot be used with option '--share <count>'", 'pack', ...args)
  })
})

describe('slices', () => {
  it.each<[string, (json: Json, maps: Json) => void, RegExp]>([
    [
      'a normal map outside the array',
      (_, maps) => (maps.layers[1].normalTexture.slice = 7),
      /layer "expression": normal: no such slice, got 7, allowed: 0 to 1/,
    ],
    [
      'an area outside the array',
      (_, maps) => (maps.areas[0].texture.slice = 9),
      /missing slice in texture .*, got 9/,
    ],
    [
      'an image among slices',
      (_, maps) => delete maps.layers[0].normalTexture.slice,
      /layers\[0\]\.normalTexture is not in the texture array of layers\[1\]\.normalTexture/,
    ],
    [
      'two arrays for one kind of map',
      (_, maps) => (maps.areas[2].texture.index = maps.layers[0].normalTexture.index),
      /areas\[2\]\.texture is not in the texture array of areas\[0\]\.texture/,
    ],
    [
      'an array that serves as an image too',
      (_, maps) => (maps.layers[0].occlusionTexture = { index: maps.areas[0].texture.index }),
      /occlusionTexture has no slice/,
    ],
    [
      'an array as the normal map of the skin',
      (json, maps) => (json.materials[0].normalTexture.index = maps.layers[0].normalTexture.index),
      /is an array of 2 slices, but is used without a slice index; .* \(ARRAY_AS_IMAGE\)/,
    ],
    [
      'arrays without slices',
      (_, maps) => {
        for (const { texture } of maps.areas) delete texture.slice
      },
      /ARRAY_AS_IMAGE/,
    ],
    ['a negative slice', (_, maps) => (maps.areas[0].texture.slice = -1), /slice is out of range, got -1/],
  ])('are checked: %s', async (_, spoil, message) => {
    expect(await findings(spoil)).toMatch(message)
    expect(process.exitCode).toBe(1)
  })
})
