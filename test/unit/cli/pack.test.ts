import { readFileSync, rmSync } from 'node:fs'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { dedup, prune, textureCompress } from '@gltf-transform/functions'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import { parseWrinkleMaps } from 'furrow/internal'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { STRAIGHT } from '../../drivers.ts'
import { jsonOf, withJson } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { AREAS, faceBytes, grayOf, painted, Workshop, wrinklesIn } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
let folder = ''

/** Reads the weights of an area's gray image in a folder. */
async function weights(path: string): Promise<number[]> {
  return (await grayOf(path)).map((value) => 255 - value)
}

beforeAll(async () => {
  folder = await shop.makeFolder('face')
})

describe('furrow pack', () => {
  it('reads every layer and area of a folder in alphabetical order', async () => {
    const out = shop.path('a.glb')
    await shop.run('pack', folder, '-o', out)
    expect(shop.printed).toContain(
      'a.glb: material "skin"; layers: age, expression; areas: brow, cheek, chin',
    )
    expect(shop.warned).toBe('')
    const json = wrinklesIn(out)
    const maps = parseWrinkleMaps(json, 99)
    expect(maps.layers.map(({ name, kind }) => [name, kind])).toEqual([
      ['age', 'replace'],
      ['expression', 'replace'],
    ])
    expect(maps.layers[0].baseColorTexture).toBeUndefined()
    expect(maps.layers[1].baseColorTexture).toBeDefined()
    expect(maps.areas.map(({ name, layer, channel }) => [name, layer, channel])).toEqual(
      AREAS.map((name, i) => [name, 0, i % 3]),
    )
    expect(new Set(maps.areas.map(({ texture }) => texture.index)).size).toBe(2)
  })

  it('keeps everything else in the file, including unknown data', async () => {
    const face = await faceBytes()
    const json = jsonOf(face)
    json.extensions = { VRM_like: { meta: { texture: 0 }, list: [1, 2] } }
    json.extensionsUsed = ['VRM_like']
    shop.write('odd.glb', withJson(face, json))
    await shop.run('pack', folder, '--face', shop.path('odd.glb'), '-o', shop.path('odd-packed.glb'))
    const packed = jsonOf(readFileSync(shop.path('odd-packed.glb')))
    expect(packed.extensions).toEqual(json.extensions)
    expect(packed.meshes).toEqual(json.meshes)
    expect(packed.accessors).toEqual(json.accessors)
    expect(packed.bufferViews.slice(0, json.bufferViews.length)).toEqual(json.bufferViews)
    expect(packed.textures.slice(0, json.textures.length)).toEqual(json.textures)
    expect(packed.extensionsUsed).toEqual(['VRM_like', NAME])
    expect(packed.extensionsRequired).toBeUndefined()
  })

  it('keeps the painted weights, in either convention', async () => {
    await shop.run('pack', folder, '-o', shop.path('a.glb'))
    await shop.run('unpack', shop.path('a.glb'), '-o', shop.path('w'), '--white-is-visible')
    const document = JSON.parse(readFileSync(shop.path('w/wrinkles.json'), 'utf8'))
    expect(document.areas[3]).toEqual({ name: 'eye', image: 'areas/eye.png', convention: 'weight' })
    const white = await grayOf(shop.path('w/areas/eye.png'))
    expect(white).toEqual(await weights(`${folder}/areas/eye.png`))
    // The folder has the same images and no document, so the option tells what black means.
    shop.write('plain/layers/x/normal.png', await noise(1))
    shop.write('plain/areas/eye.png', readFileSync(shop.path('w/areas/eye.png')))
    const args = [shop.path('plain'), '--face', `${folder}/face.glb`, '-o', shop.path('p.glb')]
    await shop.run('pack', ...args, '--white-is-visible')
    await shop.run('unpack', shop.path('p.glb'), '-o', shop.path('pu'))
    expect(await weights(shop.path('pu/areas/eye.png'))).toEqual(white)
  })

  it.each(['1', '3', '4'])('restores the same folder and file, with %s areas per image', async (share) => {
    const rich = await shop.makeFolder('rich')
    shop.json('rich/wrinkles.json', {
      version: 1,
      layers: [
        {
          name: 'expression',
          normalScale: 0.5,
          occlusion: 'layers/age/normal.png',
          occlusionStrength: 0.5,
        },
        { name: 'age', kind: 'detail', height: 'layers/expression/normal.png', heightAmplitude: 0.003 },
      ],
      areas: [
        { name: 'nose', image: 'areas/nose.png', combine: 'max', activation: 0.25 },
        { name: 'br/ow', image: 'areas/brow.png', layer: 'age' },
        { name: 'BR/OW', image: 'areas/cheek.png' },
        { name: 'chin', image: 'areas/chin.png' },
      ],
      drivers: [
        { type: 'morph', area: 'nose', targets: [{ name: 'browInnerUp', weight: 1 }], curve: STRAIGHT },
        { type: 'weather', area: 'chin', limit: 2 },
      ],
    })
    const [one, two] = [shop.path(`one${share}.glb`), shop.path(`two${share}.glb`)]
    await shop.run('pack', rich, '-o', one, '--share', share)
    await shop.run('unpack', one, '-o', shop.path(`f${share}`))
    await shop.run('pack', shop.path(`f${share}`), '-o', two, '--share', share)
    await shop.run('unpack', two, '-o', shop.path(`g${share}`))
    expect(readFileSync(two).equals(readFileSync(one))).toBe(true)
    expect(shop.files(`g${share}`)).toEqual(shop.files(`f${share}`))
    expect(Object.keys(shop.files(`f${share}`))).toContain('areas/BR_OW-2.png')
    expect(jsonOf(readFileSync(shop.path(`f${share}/face.glb`)))).toEqual(jsonOf(await faceBytes()))
    expect(await weights(shop.path(`f${share}/areas/chin.png`))).toEqual(
      await weights(`${rich}/areas/chin.png`),
    )
    expect(wrinklesIn(one)).toMatchObject({
      layers: [
        { name: 'expression', normalTexture: { scale: 0.5 }, occlusionTexture: { strength: 0.5 } },
        { name: 'age', kind: 'detail', heightTexture: { amplitude: 0.003 } },
      ],
      areas: [{ combine: 'max', activation: 0.25 }, { layer: 1 }, {}, {}],
      drivers: [{ type: 'morph' }, { type: 'weather', limit: 2 }],
    })
  })

  it('replaces the existing wrinkles of a face', async () => {
    await shop.run('pack', folder, '-o', shop.path('a.glb'))
    await shop.run('pack', folder, '--face', shop.path('a.glb'), '-o', shop.path('b.glb'))
    expect(readFileSync(shop.path('b.glb')).equals(readFileSync(shop.path('a.glb')))).toBe(true)
  })

  it('resamples the areas to the requested size', async () => {
    await shop.run('pack', folder, '-o', shop.path('s.glb'), '--area-size', '32', '--json')
    expect(JSON.parse(shop.printed)).toMatchObject({ areaSize: 32, areas: AREAS, drivers: 0 })
    await shop.run('unpack', shop.path('s.glb'), '-o', shop.path('s'))
    expect(await sharp(shop.path('s/areas/nose.png')).metadata()).toMatchObject({ width: 32, height: 32 })
  })

  it('makes files whose wrinkles survive transforms of glTF-Transform', async () => {
    await shop.run('pack', folder, '-o', shop.path('a.glb'))
    const io = new NodeIO().registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    const document = await io.read(shop.path('a.glb'))
    await document.transform(
      dedup(),
      prune(),
      textureCompress({ encoder: sharp, targetFormat: 'webp', resize: [64, 64], lossless: true }),
    )
    await io.write(shop.path('t.glb'), document)
    await shop.run('unpack', shop.path('t.glb'), '-o', shop.path('t'))
    for (const [i, name] of AREAS.entries()) {
      const small = await weights(shop.path(`t/areas/${name}.png`))
      const [inside, outside] = [0, 4].map((shift) => small[20 * 64 + ((8 * (i + shift)) % 64) + 4])
      expect(inside, name).toBeGreaterThan(190)
      expect(outside, name).toBeLessThan(5)
    }
  })

  it('warns about a missing blendshape and an invisible area, and keeps both', async () => {
    const odd = await shop.makeFolder('odd')
    shop.json('odd/wrinkles.json', {
      version: 1,
      drivers: [{ type: 'morph', area: 'nose', targets: [{ name: 'noseSneer' }] }],
    })
    shop.write('odd/areas/zero.png', await painted(99))
    await shop.run('pack', odd, '-o', shop.path('warned.glb'))
    expect(shop.warned).toContain(
      'target "noseSneer" of a driver of area "nose" does not exist; the reference to it is kept',
    )
    expect(shop.warned).toContain('area "zero" is empty')
    expect(wrinklesIn(shop.path('warned.glb')).drivers[0].targets[0].name).toBe('noseSneer')
    expect(wrinklesIn(shop.path('warned.glb')).areas.at(-1).name).toBe('zero')
  })
})

describe('furrow pack with invalid input', () => {
  const out = ['-o', shop.path('out.glb')]
  const document = (rest: object) => (at: string) => shop.json(`${at}/wrinkles.json`, rest)
  const area = (image: string) => document({ areas: [{ name: 'a', image }] })

  it.each<[string, (at: string) => unknown, string]>([
    ['no JSON', (at) => shop.write(`${at}/wrinkles.json`, '{'), ', allowed: JSON; correct the file'],
    [
      'JSON of the wrong shape',
      (at) => shop.json(`${at}/wrinkles.json`, [1]),
      'the document must be an object',
    ],
    ['no areas', document({ areas: [] }), 'no areas in'],
    [
      'an unknown layer',
      document({ areas: [{ name: 'nose', layer: 'x' }] }),
      'area "nose" is on an unknown layer',
    ],
    ['a missing image', area('no.png'), 'wrinkles.json (it does not exist'],
    ['an address elsewhere', area('https://x/y'), 'references a remote file'],
    [
      'an address outside the folder',
      area('../../secret.png'),
      'references a file outside its folder, got "../../secret.png"',
    ],
    [
      'a driver of nothing',
      document({ drivers: [{ type: 'morph', area: 'x' }] }),
      'drivers[0].area is unknown',
    ],
    [
      'heights that no layer has an amplitude for',
      async (at) => shop.write(`${at}/layers/age/height.png`, await noise(1)),
      'layers/age/height.png requires heightAmplitude, which its layer in wrinkles.json lacks, allowed: metres from black to white',
    ],
    [
      'an image cut off',
      async (at) => shop.write(`${at}/areas/eye.png`, (await painted(1)).subarray(0, 300)),
      'eye.png',
    ],
    [
      'no image',
      (at) => shop.write(`${at}/layers/age/normal.png`, 'hello'),
      'cannot read the image layers/age/normal.png',
    ],
    [
      'transparent texels',
      async (at) => shop.write(`${at}/layers/age/normal.png`, await noise(1, 4)),
      'layers/age/normal.png has transparent texels',
    ],
    [
      'layers of two sizes',
      async (at) => shop.write(`${at}/layers/age/normal.png`, await noise(1, 3, 32)),
      'the normal maps of the layers differ in size, got "32 x 32, 16 x 16"',
    ],
    [
      'no face',
      (at) => rmSync(shop.path(`${at}/face.glb`)),
      'does not exist); add it, or pass another face with --face',
    ],
    [
      'a face without a mesh',
      async (at) => shop.write(`${at}/face.glb`, withJson(await faceBytes(), { asset: { version: '2.0' } })),
      'no such mesh, allowed: the file has none with texture coordinates',
    ],
    [
      'two meshes to choose from',
      async (at) => shop.write(`${at}/face.glb`, await faceBytes(['left', 'right'])),
      'several candidates for the mesh, allowed: left, right; name one with --mesh',
    ],
  ])('reports %s in one line and writes nothing', async (name, spoil, message) => {
    const at = `bad-${name.replaceAll(' ', '-')}`
    const path = await shop.makeFolder(at)
    await spoil(at)
    await shop.fails(message, 'pack', path, ...out)
  })

  it.each([
    ['an unknown mesh', ['--mesh', 'nose'], 'no such mesh, got "nose", allowed: skin, eyes'],
    ['an unknown material', ['--material', 'x'], 'no such material of that mesh, got "x", allowed: skin'],
    ['no such face', ['--face', 'none.glb'], 'cannot read the face none.glb'],
  ])('refuses %s', (_, args, message) => shop.fails(message, 'pack', folder, ...out, ...args))
})
