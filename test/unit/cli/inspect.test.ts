import { readFileSync } from 'node:fs'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { areaSizes, mapSizes } from '../../../packages/files/src/wrinkles/sizes.ts'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { ramp } from '../../drivers.ts'
import { editGlb, jsonOf } from '../../glb.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
const face = shop.path('wrinkled.glb')

beforeAll(async () => {
  const folder = await shop.makeFolder('face')
  shop.json('face/wrinkles.json', {
    version: 1,
    layers: [
      { name: 'expression', normalScale: 0.5 },
      { name: 'age', kind: 'detail' },
    ],
    drivers: [
      { type: 'morph', area: 'nose', targets: [{ name: 'browInnerUp', weight: 0.5 }] },
      { type: 'morph', area: 'brow', targets: [{ name: 'browInnerUp' }], curve: ramp(0, 0.5) },
      { type: 'weather' },
      { type: 'expression', name: 'joy', targets: [{ name: 'browInnerUp', weight: 0.5 }] },
    ],
  })
  await shop.run('pack', folder, '-o', face)
})

describe('sizes on the GPU', () => {
  it.each([
    // All mipmap levels count: 4 x 4 + 2 x 2 + 1 x 1 texels, or one block of 4 x 4 texels per level.
    [4, 4, { uncompressed: 4 * 21, bits8: 48, bits4: 24 }],
    [5, 2, { uncompressed: 4 * (10 + 2 + 1), bits8: 16 * (2 + 1 + 1), bits4: 8 * 4 }],
    [512, 512, { uncompressed: 1398100, bits8: 349552, bits4: 174776 }],
  ])('of a map of %d x %d', (width, height, sizes) => expect(mapSizes(width, height)).toEqual(sizes))

  it('of an area', () => {
    expect(areaSizes(128, 128)).toEqual({ uncompressed: 16384, bits8: 8192, bits4: 8192 })
  })
})

describe('furrow inspect', () => {
  it('prints layers, areas, drivers and sizes', async () => {
    await shop.run('inspect', face)
    const lines = shop.printed.split('\n')
    expect(lines[0]).toBe(`${face}: wrinkles on material "skin"`)
    expect(lines).toContainEqual(
      expect.stringMatching(/^expression +replace +normal x 0\.5 +16 x 16 +png +\d/),
    )
    expect(lines).toContainEqual(expect.stringMatching(/^expression +replace +baseColor /))
    expect(lines).toContainEqual(expect.stringMatching(/^age +detail +normal +16 x 16/))
    expect(lines).toContainEqual(
      expect.stringMatching(/^cheek +expression +128 x 128 +texture \d+ G +sum +0 +12\.5% +1\.00$/),
    )
    expect(lines).toContain('  nose = 0.5 browInnerUp')
    expect(lines).toContain('  brow = browInnerUp, curve (0, 0) (0.5, 1)')
    expect(lines).toContain('  weather: unknown type, kept as it is')
    expect(lines.indexOf('expression joy: 0.5 browInnerUp')).toBe(
      lines.indexOf('  weather: unknown type, kept as it is') + 2,
    )
  })

  it('prints JSON, in which sizes count every image once', async () => {
    await shop.run('inspect', face, '--json')
    const report = JSON.parse(shop.printed)
    const json = jsonOf(readFileSync(face))
    const images = json.images
      .slice(4)
      .map(({ bufferView }: { bufferView: number }) => json.bufferViews[bufferView])
    expect(images).toHaveLength(5)
    expect(report.imageBytes).toBe(
      images.reduce((sum: number, view: { byteLength: number }) => sum + view.byteLength, 0),
    )
    const maps = 3 * mapSizes(16, 16).uncompressed
    expect(report.gpu.uncompressed).toBe(maps + 5 * 128 * 128)
    // The influence map has two layers of 32-bit floats.
    expect(report.influenceMapBytes).toBe(8 * 128 * 128)
    expect(report.fileBytes).toBe(readFileSync(face).length)
    expect(report.areas[0]).toMatchObject({ name: 'brow', channel: 'R', coverage: 0.125, largest: 1 })
    expect(report.drivers).toHaveLength(4)
  })

  it('draws every map and area into one picture', async () => {
    const path = shop.path('deep/sheet.png')
    await shop.run('inspect', face, '--sheet', path)
    expect(shop.printed).toMatch(/deep\/sheet\.png: all maps and areas\n$/)
    const { data, info } = await sharp(path).raw().toBuffer({ resolveWithObject: true })
    // The picture has 3 maps and 5 areas, in 4 columns.
    expect(info).toMatchObject({ width: 4 * 266 + 10, height: 2 * 292 + 10, channels: 3 })
    const red = (x: number, y: number) => data[3 * (y * info.width + x)] - data[3 * (y * info.width + x) + 1]
    const average = (tile: number, column: number) => {
      const [left, top] = [10 + (tile % 4) * 266 + column * 32, 10 + Math.floor(tile / 4) * 292]
      let sum = 0
      for (let y = 64; y < 192; y++) for (let x = 8; x < 24; x++) sum += red(left + x, top + y)
      return sum / (128 * 16)
    }
    // `brow` covers column 0 of its picture, and `cheek` column 1. The base colour, which is noise, is equal in both pictures and cancels
    // out in the difference.
    expect(average(3, 0) - average(4, 0)).toBeGreaterThan(50)
    expect(average(4, 1) - average(3, 1)).toBeGreaterThan(50)
    expect(average(3, 4) - average(4, 4)).toBe(0)
  })

  it('asks for the material if several have wrinkles', async () => {
    const two = editGlb(readFileSync(face), ({ materials }) => {
      materials[1].extensions = materials[0].extensions
    })
    shop.write('two.glb', two)
    const problem = `several materials with wrinkles in ${shop.path('two.glb')}, allowed: skin, eyes; name one with --material`
    await shop.fails(problem, 'inspect', shop.path('two.glb'))
    const report = await shop.output('inspect', shop.path('two.glb'), '--material', 'eyes', '--json')
    expect(JSON.parse(report).material).toBe('eyes')
  })

  it('refuses a material without wrinkles', () =>
    shop.fails('has no wrinkles', 'inspect', shop.path('face/face.glb'), '--material', 'skin'))
})

describe('the blendshapes of a face without wrinkles', () => {
  it('are listed with the shapes recognised by motion and by name', async () => {
    const [face] = BARE_FACES
    await shop.run('inspect', face!.path)
    expect(shop.printed).toMatch(/\njawOpen +jawOpen +\d\.\d\d +motion and name\n/)
    shop.printed = ''
    await shop.run('inspect', face!.path, '--json')
    const { shapes } = JSON.parse(shop.printed) as { shapes: { blendshape: string; shape: string }[] }
    for (const { blendshape, shape } of shapes.filter(({ blendshape }) =>
      /(Smile|Blink)_L$/.test(blendshape),
    ))
      expect(shape).toBe(blendshape.replace('_L', 'Left'))
    expect(shapes.length).toBeGreaterThan(50)
  })

  it('are listed by name alone on a mesh that is no face', async () => {
    await shop.run('inspect', shop.write('plain.glb', await faceBytes()), '--json')
    const { shapes } = JSON.parse(shop.printed) as { shapes: { by: string }[] }
    expect(shapes.map(({ by }) => by)).not.toContain('geometry')
  })
})
