import { closeSync, openSync, readFileSync } from 'node:fs'
import fc from 'fast-check'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { inspectCommand } from '../../../packages/cli/src/commands/inspect.ts'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { mutate, mutation } from '../gltf/mutations.ts'
import { jsonOf, noise, painted, Workshop, withJson } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
const face = shop.path('wrinkled.glb')

type Json = ReturnType<typeof jsonOf>

beforeAll(async () => {
  await shop.run(packCommand, await shop.makeFolder('face'), '-o', face)
})

/** The codes that are found once `spoil` has changed the file's JSON. */
async function codesOf(path: string): Promise<string[]> {
  shop.printed = ''
  await shop.run(validateCommand, path, '--json')
  return JSON.parse(shop.printed).findings.map(({ code }: { code: string }) => code)
}

function spoilt(spoil: (json: Json, maps: Json) => void): string {
  const bytes = readFileSync(face)
  const json = jsonOf(bytes)
  spoil(json, json.materials[0].extensions[NAME])
  return shop.write('spoilt.glb', withJson(bytes, json))
}

describe('furrow validate', () => {
  it('finds nothing wrong with a packed face, not even a warning', async () => {
    await shop.run(validateCommand, face)
    expect(shop.printed).toBe(`${face}: 0 errors, 0 warnings\n`)
    expect(process.exitCode).toBeUndefined()
  })

  it('asks the Khronos validator', async () => {
    const path = spoilt((json) => Object.assign(json.accessors[0], { count: 4000 }))
    await shop.run(validateCommand, path, '--all')
    expect(shop.printed).toMatch(/^error: \/accessors\/0.*\(ACCESSOR_TOO_LONG\)$/m)
    expect(process.exitCode).toBe(1)
  })

  it('reads a pipe that the shell has opened once', async () => {
    const file = openSync(face, 'r')
    await shop.run(validateCommand, `/dev/fd/${file}`)
    closeSync(file)
    expect(shop.printed).toBe(`/dev/fd/${file}: 0 errors, 0 warnings\n`)
  })

  it('sums up the errors about the rest of the file, and lists those about the wrinkles', async () => {
    const path = spoilt((json, maps) => {
      for (const { min, max } of json.accessors) for (const limits of [min, max]) if (limits) limits[0] += 0.5
      maps.areas[1].layer = 2
    })
    await shop.run(validateCommand, path)
    const [own, rest, ...more] = shop.printed.trimEnd().split('\n')
    expect(own).toMatch(/^error: \/materials\/0\/extensions\/.*\(INVALID\)$/)
    const summary =
      /^(\d+) errors about the rest of the file, not the wrinkles: (\d+) ACCESSOR_MIN_MISMATCH, .*; list them with --all$/
    expect(rest).toMatch(summary)
    const [, all, ofMin] = summary.exec(rest!)!.map(Number)
    expect(ofMin).toBeGreaterThan(0)
    expect(more).toEqual([`${path}: ${all! + 1} errors, 0 warnings`])
    expect(process.exitCode).toBe(1)
    shop.printed = ''
    await shop.run(validateCommand, path, '--all')
    expect(shop.printed.match(/^error: /gm)).toHaveLength(all! + 1)
    expect(shop.printed).not.toContain('rest of the file')
  })

  it.each<[string, (json: Json, maps: Json) => void, string]>([
    ['an index out of range', (_, maps) => Object.assign(maps.areas[0].texture, { index: 99 }), 'INVALID'],
    ['two areas of one name', (_, maps) => Object.assign(maps.areas[1], { name: 'brow' }), 'INVALID'],
    ['a layer beyond the list', (_, maps) => Object.assign(maps.areas[1], { layer: 2 }), 'INVALID'],
    [
      'an extension that is not an object',
      (json) => Object.assign(json.materials[0].extensions, { [NAME]: 1 }),
      'INVALID',
    ],
    ['a missing image', (json) => json.images.pop(), 'INVALID'],
    ['an undeclared extension', (json) => delete json.extensionsUsed, 'NOT_DECLARED'],
  ])('counts %s as an error', async (_, spoil, code) => {
    expect(await codesOf(spoilt(spoil))).toContain(code)
    expect(process.exitCode).toBe(1)
  })

  it.each<[string, (json: Json, maps: Json) => void, string]>([
    ['a required extension', (json) => Object.assign(json, { extensionsRequired: [NAME] }), 'REQUIRED'],
    [
      'other texture coordinates',
      (_, maps) => Object.assign(maps.areas[0].texture, { texCoord: 1 }),
      'TEXCOORD',
    ],
    [
      'an unknown blendshape',
      (_, maps) =>
        Object.assign(maps, { drivers: [{ type: 'morph', area: 'nose', targets: [{ name: 'x' }] }] }),
      'DRIVER_NAME',
    ],
    [
      'an unknown driver',
      (_, maps) => Object.assign(maps, { drivers: [{ type: 'weather' }] }),
      'DRIVER_TYPE',
    ],
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

  it('counts no blendshape as missing that a muscle is', async () => {
    const muscle = { type: 'muscle', name: 'x', origin: [0, 0, 0], insertion: [0, 1, 0] }
    const drivers = [muscle, { type: 'morph', area: 'nose', targets: [{ name: 'x' }] }]
    expect(await codesOf(spoilt((_, maps) => Object.assign(maps, { drivers })))).not.toContain('DRIVER_NAME')
  })

  it('sees in the images what the JSON does not tell', async () => {
    const folder = await shop.makeFolder('odd')
    const jpeg = await sharp(await noise(1, 3))
      .jpeg()
      .toBuffer()
    shop.write('odd/layers/age/normal.jpg', jpeg)
    shop.write('odd/layers/age/roughness.png', await noise(1, 3, 12))
    shop.write('odd/areas/zero.png', await painted(99))
    shop.json('odd/wrinkles.json', { version: 1, layers: [{ name: 'age', normal: 'layers/age/normal.jpg' }] })
    await shop.run(packCommand, folder, '-o', shop.path('odd.glb'), '--share', '4')
    expect(await codesOf(shop.path('odd.glb'))).toEqual([
      'MAP_SIZES',
      'JPEG_NORMALS',
      'AREA_UNDER_ALPHA',
      'AREA_UNDER_ALPHA',
      'AREA_UNDER_ALPHA',
      'AREA_INVISIBLE',
    ])
    const both = jsonOf(readFileSync(face))
    // The second layer takes an image of another size: the first area's.
    Object.assign(both.materials[0].extensions[NAME].layers[1].normalTexture, {
      index: both.materials[0].extensions[NAME].areas[0].texture.index,
    })
    const path = shop.write('sizes.glb', withJson(readFileSync(face), both))
    expect(await codesOf(path)).toContain('LAYER_SIZES')
    expect(process.exitCode).toBe(1)
  })

  it('reports whatever is wrong with an image, and is never brought down by it', async () => {
    const whole = readFileSync(face)
    const { images, bufferViews } = jsonOf(whole)
    const start = whole.length - jsonOf(whole).buffers[0].byteLength
    for (const { bufferView } of images.slice(-3)) {
      const { byteOffset, byteLength } = bufferViews[bufferView]
      for (const at of [9, 12, 13, 21, 35, byteLength >> 1]) {
        const bytes = Buffer.from(whole)
        bytes.fill(0xa5, start + byteOffset + at, start + byteOffset + at + 4)
        process.exitCode = undefined
        await codesOf(shop.write('damaged.glb', bytes))
        expect(process.exitCode, `${bufferView} at ${at}`).toBe(1)
      }
    }
  })

  it('says so where the Khronos validator gives up', async () => {
    const path = spoilt((json) => {
      const indices = { bufferView: 0, byteOffset: 1, componentType: 5125 }
      json.accessors[0].sparse = { count: 1, indices, values: { bufferView: 0 } }
    })
    await shop.run(validateCommand, path)
    expect(shop.printed).toMatch(/^error: the Khronos validator gave up: .*multiple of 4.* \(VALIDATOR\)$/m)
    expect(process.exitCode).toBe(1)
  })

  it('sums up the warnings about the rest of the file, and lists them with --all', async () => {
    const path = spoilt((json) => {
      for (const node of json.nodes) node.unexpected = true
    })
    const codes = ['UNEXPECTED_PROPERTY', 'UNEXPECTED_PROPERTY']
    expect(await codesOf(path)).toEqual(codes)
    shop.printed = ''
    await shop.run(validateCommand, path)
    expect(shop.printed).toBe(
      '2 warnings about the rest of the file, not the wrinkles: 2 UNEXPECTED_PROPERTY; list them with --all\n' +
        `${path}: 0 errors, 2 warnings\n`,
    )
    shop.printed = ''
    await shop.run(validateCommand, path, '--all')
    expect(shop.printed.match(/^warning: \/nodes\/\d/gm)).toHaveLength(2)
    expect(process.exitCode).toBeUndefined()
  })

  it.each<[string, (json: Json, maps: Json) => void, string]>([
    [
      'an unlit material',
      (json) => Object.assign(json.materials[0].extensions, { KHR_materials_unlit: {} }),
      'UNLIT',
    ],
    ['a mesh without normals', (json) => delete json.meshes[0].primitives[0].attributes.NORMAL, 'ATTRIBUTE'],
  ])('counts %s as an error: it cannot wrinkle', async (_, spoil, code) => {
    expect(await codesOf(spoilt(spoil))).toContain(code)
    expect(process.exitCode).toBe(1)
  })

  it('refuses a file cut off at every 1% of its length', async () => {
    const whole = readFileSync(face)
    for (let percent = 0; percent < 100; percent++) {
      const path = shop.write('cut.glb', whole.subarray(0, Math.floor((whole.length * percent) / 100)))
      const failure = await shop.failure(validateCommand, path)
      expect(failure.name, `${percent}%: ${failure.stack}`).toBe('FurrowError')
      expect(failure.message).toContain('furrow validate: ')
    }
  })

  it('survives whatever stands in the JSON', async () => {
    const bytes = readFileSync(face)
    const json = jsonOf(bytes)
    await fc.assert(
      fc.asyncProperty(fc.array(mutation, { minLength: 1, maxLength: 3 }), async (mutations) => {
        const spoiltJson = mutations.reduce(mutate, structuredClone(json))
        const path = shop.write('mutated.glb', withJson(bytes, spoiltJson))
        for (const args of [
          [validateCommand, path],
          [inspectCommand, path],
          [packCommand, shop.path('face'), '--face', path, '-o', shop.path('again.glb')],
        ] as const) {
          const [command, ...rest] = args
          const failure = await shop.run(command, ...rest).then(
            () => undefined,
            (error) => error,
          )
          if (failure !== undefined) expect(failure.name, failure.stack).toBe('FurrowError')
        }
      }),
      { numRuns: 60, seed: 5 },
    )
  })
})
