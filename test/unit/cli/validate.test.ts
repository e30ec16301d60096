import { closeSync, openSync, readFileSync } from 'node:fs'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { editGlb, jsonOf } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { painted, Workshop } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
const face = shop.path('wrinkled.glb')

type Json = ReturnType<typeof jsonOf>

beforeAll(async () => {
  await shop.run('pack', await shop.makeFolder('face'), '-o', face)
})

/** Returns the codes of findings in a file. */
async function codesOf(path: string): Promise<string[]> {
  const { findings } = JSON.parse(await shop.output('validate', path, '--json'))
  return findings.map(({ code }: { code: string }) => code)
}

function spoilt(spoil: (json: Json, maps: Json) => void): string {
  const edited = editGlb(readFileSync(face), (json) => spoil(json, json.materials[0].extensions[NAME]))
  return shop.write('spoilt.glb', edited)
}

describe('furrow validate', () => {
  it('accepts a packed face without a warning', async () => {
    await shop.run('validate', face)
    expect(shop.printed).toBe(`${face}: 0 errors, 0 warnings\n`)
    expect(process.exitCode).toBeUndefined()
  })

  it('runs the Khronos validator', async () => {
    const path = spoilt((json) => Object.assign(json.accessors[0], { count: 4000 }))
    await shop.run('validate', path, '--all')
    expect(shop.printed).toMatch(/^error: \/accessors\/0.*\(ACCESSOR_TOO_LONG\)$/m)
    expect(process.exitCode).toBe(1)
  })

  it('reads a pipe of the shell only once', async () => {
    const file = openSync(face, 'r')
    await shop.run('validate', `/dev/fd/${file}`)
    closeSync(file)
    expect(shop.printed).toBe(`/dev/fd/${file}: 0 errors, 0 warnings\n`)
  })

  it('lists errors about the wrinkles and summarises the others', async () => {
    const path = spoilt((json, maps) => {
      for (const { min, max } of json.accessors) for (const limits of [min, max]) if (limits) limits[0] += 0.5
      maps.areas[1].layer = 2
    })
    await shop.run('validate', path)
    const [own, rest, ...more] = shop.printed.trimEnd().split('\n')
    expect(own).toMatch(/^error: \/materials\/0\/extensions\/.*\(INVALID\)$/)
    const summary =
      /^(\d+) errors outside the wrinkles: (\d+) ACCESSOR_MIN_MISMATCH, .*; list them with --all$/
    expect(rest).toMatch(summary)
    const [, all, ofMin] = summary.exec(rest!)!.map(Number)
    expect(ofMin).toBeGreaterThan(0)
    expect(more).toEqual([`${path}: ${all! + 1} errors, 0 warnings`])
    expect(process.exitCode).toBe(1)
    const whole = await shop.output('validate', path, '--all')
    expect(whole.match(/^error: /gm)).toHaveLength(all! + 1)
    expect(whole).not.toContain('outside the wrinkles')
  })

  it.each<[string, (json: Json, maps: Json) => void, string]>([
    ['an index out of range', (_, maps) => Object.assign(maps.areas[0].texture, { index: 99 }), 'INVALID'],
    ['a missing image', (json) => json.images.pop(), 'INVALID'],
    ['an undeclared extension', (json) => delete json.extensionsUsed, 'NOT_DECLARED'],
    ['an unlit material', ({ materials }) => (materials[0].extensions.KHR_materials_unlit = {}), 'UNLIT'],
    ['a mesh without normals', (json) => delete json.meshes[0].primitives[0].attributes.NORMAL, 'ATTRIBUTE'],
  ])('counts %s as an error', async (_, spoil, code) => {
    expect(await codesOf(spoilt(spoil))).toContain(code)
    expect(process.exitCode).toBe(1)
  })

  const unknown = { type: 'morph', area: 'nose', targets: [{ name: 'x' }] }
  it.each<[string, (json: Json, maps: Json) => void, string]>([
    ['a required extension', (json) => Object.assign(json, { extensionsRequired: [NAME] }), 'REQUIRED'],
    ['other texture coordinates', (_, maps) => (maps.areas[0].texture.texCoord = 1), 'TEXCOORD'],
    ['an unknown blendshape', (_, maps) => (maps.drivers = [unknown]), 'DRIVER_NAME'],
    ['an unknown driver', (_, maps) => (maps.drivers = [{ type: 'weather' }]), 'DRIVER_TYPE'],
    [
      'MToon, whose fallback is unlit,',
      (json) => {
        const names = ['VRMC_materials_mtoon', 'KHR_materials_unlit']
        for (const name of names) json.materials[0].extensions[name] = {}
        json.extensionsUsed.push(...names)
      },
      'MTOON',
    ],
    ['no wrinkles at all', (json) => delete json.materials[0].extensions, 'NO_WRINKLES'],
  ])('counts %s as a warning', async (_, spoil, code) => {
    expect(await codesOf(spoilt(spoil))).toContain(code)
    expect(process.exitCode).toBeUndefined()
  })

  it('does not report a muscle as a missing blendshape', async () => {
    const muscle = { type: 'muscle', name: 'x', origin: [0, 0, 0], insertion: [0, 1, 0] }
    expect(await codesOf(spoilt((_, maps) => (maps.drivers = [muscle, unknown])))).not.toContain(
      'DRIVER_NAME',
    )
  })

  it('finds problems inside images', async () => {
    const folder = await shop.makeFolder('odd')
    const jpeg = await sharp(await noise(1))
      .jpeg()
      .toBuffer()
    shop.write('odd/layers/age/normal.jpg', jpeg)
    shop.write('odd/layers/age/roughness.png', await noise(1, 3, 12))
    shop.write('odd/areas/zero.png', await painted(99))
    shop.json('odd/wrinkles.json', { version: 1, layers: [{ name: 'age', normal: 'layers/age/normal.jpg' }] })
    await shop.run('pack', folder, '-o', shop.path('odd.glb'), '--share', '4')
    expect(await codesOf(shop.path('odd.glb'))).toEqual([
      'MAP_SIZES',
      'JPEG_NORMALS',
      'AREA_UNDER_ALPHA',
      'AREA_UNDER_ALPHA',
      'AREA_UNDER_ALPHA',
      'AREA_INVISIBLE',
    ])
    // Makes the second layer use the image of the first area, which has another size.
    const sizes = spoilt((_, { layers, areas }) => {
      layers[1].normalTexture.index = areas[0].texture.index
    })
    expect(await codesOf(sizes)).toContain('LAYER_SIZES')
    expect(process.exitCode).toBe(1)
  })

  it.each([9, 12, 13, 21, 35, 60])('reports an image that is wrong at byte %i', async (at) => {
    const bytes = Buffer.from(readFileSync(face))
    const { images, bufferViews, buffers } = jsonOf(bytes)
    const { byteOffset } = bufferViews[images.at(-1).bufferView]
    const start = bytes.length - buffers[0].byteLength + byteOffset + at
    await codesOf(shop.write('damaged.glb', bytes.fill(0xa5, start, start + 4)))
    expect(process.exitCode).toBe(1)
  })

  it('reports that the Khronos validator failed', async () => {
    const path = spoilt((json) => {
      const indices = { bufferView: 0, byteOffset: 1, componentType: 5125 }
      json.accessors[0].sparse = { count: 1, indices, values: { bufferView: 0 } }
    })
    await shop.run('validate', path)
    expect(shop.printed).toMatch(/^error: the Khronos validator failed: .*multiple of 4.* \(VALIDATOR\)$/m)
    expect(process.exitCode).toBe(1)
  })

  it('summarises warnings outside the wrinkles, and lists them with --all', async () => {
    const path = spoilt((json) => {
      for (const node of json.nodes) node.unexpected = true
    })
    expect(await shop.output('validate', path)).toBe(
      '2 warnings outside the wrinkles: 2 UNEXPECTED_PROPERTY; list them with --all\n' +
        `${path}: 0 errors, 2 warnings\n`,
    )
    expect((await shop.output('validate', path, '--all')).match(/^warning: \/nodes\/\d/gm)).toHaveLength(2)
    expect(process.exitCode).toBeUndefined()
  })
})
