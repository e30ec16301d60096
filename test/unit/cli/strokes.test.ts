import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Document, NodeIO } from '@gltf-transform/core'
import { encodeSculpted } from 'furrow-files'
import sharp from 'sharp'
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { accessorsOf } from '../../accessors.ts'
import { across } from '../../strokes.ts'
import { sheet } from '../author/planes.ts'
import { bench, grayOf, grayPng } from './workshop.ts'

const at = bench('strokes')
const { file, run } = at
const face = file('face.glb')
const strokes = file('strokes.json')

const DOCUMENT = {
  version: 1,
  strokes: [
    {
      group: 'brow',
      points: across(0.5),
      width: 4,
      depth: 0.5,
      taper: 0,
    },
  ],
}

/** Writes a glTF file with a sheet of 100 x 100 mm for each name. The last sheet has a normal map. */
async function writeFace(target: string, names: string[], normalMap?: Uint8Array): Promise<void> {
  const document = new Document()
  const accessor = accessorsOf(document)
  const scene = document.createScene()
  for (const name of names) {
    const { positions, uvs, indices } = sheet([100, 0, 0], [0, -100, 0])
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
      .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)))
      .setIndices(accessor('SCALAR', Uint16Array.from(indices!)))
    if (normalMap) {
      const texture = document.createTexture().setImage(normalMap).setMimeType('image/png')
      primitive.setMaterial(document.createMaterial().setNormalTexture(texture))
    }
    scene.addChild(document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive)))
  }
  await new NodeIO().write(target, document)
}

beforeAll(async () => {
  await writeFace(face, ['sheet'])
  at.shop.json('strokes.json', DOCUMENT)
})

describe('furrow strokes', () => {
  it('writes the height map in 16 bits and prints its scale', async () => {
    await run(strokes, '--face', face, '-o', file('height.png'), '--size', '201')
    expect(at.printed).toContain('height.png: 201 x 201, 16-bit, 32768 = 0 mm, 1 step = 0.001 mm, -0.50..')
    const image = sharp(file('height.png'))
    expect(await image.metadata()).toMatchObject({ width: 201, height: 201, depth: 'ushort', channels: 1 })
    const { data } = await image
      .toColourspace('grey16')
      .raw({ depth: 'ushort' })
      .toBuffer({ resolveWithObject: true })
    const steps = new Uint16Array(data.buffer, data.byteOffset, data.length / 2)
    expect(steps[100 * 201 + 100]).toBe(32768 - 500)
    expect(steps[0]).toBe(32768)
  })

  it('combines the wrinkles with the normal map of the mesh, which stays the same elsewhere', async () => {
    const tilted = { width: 32, height: 32, channels: 3 as const, background: { r: 150, g: 120, b: 250 } }
    await writeFace(file('pores.glb'), ['eye', 'skin'], await sharp({ create: tilted }).png().toBuffer())
    await run(strokes, '--face', file('pores.glb'), '--normal', file('deep/folder/normal.png'))
    const { data, info } = await sharp(file('deep/folder/normal.png'))
      .raw()
      .toBuffer({ resolveWithObject: true })
    expect(info).toMatchObject({ width: 32, height: 32, channels: 3 })
    expect([...data.subarray(0, 3)]).toEqual([150, 120, 250])
    const line = 3 * (15 * 32 + 16)
    expect([...data.subarray(line, line + 3)]).not.toEqual([150, 120, 250])
  })

  it('writes areas in which black is visible, as in the paper', async () => {
    await run(strokes, '--face', face, '--areas', file('areas'))
    expect(readdirSync(file('areas'))).toEqual(['brow.png'])
    const image = sharp(file('areas/brow.png'))
    expect(await image.metadata()).toMatchObject({ width: 128, height: 128, channels: 1, depth: 'uchar' })
    const gray = await grayOf(file('areas/brow.png'))
    expect(gray[64 * 128 + 64]).toBe(0)
    expect(gray[0]).toBe(255)
  })

  describe('--into', () => {
    const set = file('set')
    const inSet = (name: string) => join(set, name)
    const draw = (document: object, ...args: string[]) => {
      return run(at.shop.json('lines.json', document), '--face', face, '--into', set, '--size', '64', ...args)
    }
    const setDocument = () => JSON.parse(readFileSync(inSet('wrinkles.json'), 'utf8'))
    /** Texel indices in a map of 32 x 32: on the line at v = 0.5, on the second line, and on neither. */
    const [LINE, SECOND, OFF] = [16 * 32 + 16, 8 * 32 + 16, 28 * 32 + 16]
    const moved = (v: number) => ({
      ...DOCUMENT,
      strokes: DOCUMENT.strokes.map((stroke) => ({
        ...stroke,
        points: across(v),
      })),
    })

    beforeEach(() => rmSync(set, { recursive: true, force: true }))

    it('makes a new folder that furrow pack reads, with heights in metres', async () => {
      await draw(DOCUMENT)
      expect(readdirSync(set).sort()).toEqual(['areas', 'layers', 'strokes.json', 'wrinkles.json'])
      const { layers, areas } = setDocument()
      expect(layers).toMatchObject([{ name: 'expression', kind: 'detail', bloodAmplitude: 0.35 }])
      // The deepest valley sets the scale. It is less than 0.5 mm deep, because texels are 1.6 mm wide. White and black are
      // equally far from the skin.
      expect(layers[0].heightAmplitude).toBeGreaterThan(0.0006)
      expect(layers[0].heightAmplitude).toBeLessThan(0.001)
      expect(areas).toEqual([{ name: 'brow', image: 'areas/brow.png' }])
      expect((await sharp(inSet('layers/expression/normal.png')).metadata()).width).toBe(64)
      for (const map of ['height', 'occlusion', 'blood', 'onset']) {
        expect((await sharp(inSet(`layers/expression/${map}.png`)).metadata()).width, map).toBe(32)
      }
      const heights = await grayOf(inSet('layers/expression/height.png'))
      expect(heights[LINE]).toBeLessThan(80)
      expect(heights[OFF]).toBe(128)
      expect((await grayOf(inSet('layers/expression/occlusion.png')))[LINE]).toBeLessThan(250)
      const onset = await grayOf(inSet('layers/expression/onset.png'))
      expect(onset[LINE]).toBeGreaterThanOrEqual(10)
      expect(onset[OFF]).toBe(0)
      const flat = { create: { width: 8, height: 8, channels: 3 as const, background: '#8080ff' } }
      await writeFace(file('flat.glb'), ['skin'], await sharp(flat).png().toBuffer())
      await at.shop.run('pack', set, '--face', file('flat.glb'), '-o', file('wrinkled.glb'))
      expect(at.printed).toContain('strokes: 1')
    })

    it('draws bulges as heights alone, which pack and unpack keep', async () => {
      const bulge = { ...DOCUMENT.strokes[0], depth: -1.5, width: 40, group: 'bag' }
      await draw({ ...DOCUMENT, strokes: [bulge, { ...bulge, depth: 0, width: 4, points: across(0.9) }] })
      expect((await grayOf(inSet('layers/expression/height.png')))[LINE]).toBeGreaterThan(250)
      expect((await grayOf(inSet('layers/expression/occlusion.png'))).every((open) => open === 255)).toBe(
        true,
      )
      expect(new Set(await grayOf(inSet('layers/expression/blood.png'))).size).toBe(1)
      expect(existsSync(inSet('layers/expression/onset.png'))).toBe(false)
      const flat = { create: { width: 8, height: 8, channels: 3 as const, background: '#8080ff' } }
      await writeFace(file('flat.glb'), ['skin'], await sharp(flat).png().toBuffer())
      await at.shop.run('pack', set, '--face', file('flat.glb'), '-o', file('raised.glb'))
      await at.shop.run('unpack', file('raised.glb'), '-o', file('unpacked'))
      const { strokes } = JSON.parse(readFileSync(file('unpacked/strokes.json'), 'utf8'))
      expect(strokes[0]).toMatchObject({ depth: -1.5, width: 40, group: 'bag' })
    })

    it('adds the sculpted heights of a layer to the strokes that it draws', async () => {
      await draw(DOCUMENT)
      const before = setDocument()
      const data = new Float32Array(64 ** 2).fill(0.5, 50 * 64)
      const sculpted = 'layers/expression/sculpted.png'
      writeFileSync(inSet(sculpted), encodeSculpted({ width: 64, height: 64, data }))
      before.layers[0].sculpted = sculpted
      writeFileSync(inSet('wrinkles.json'), JSON.stringify(before))
      await draw(moved(0.25))
      expect(setDocument().layers[0].sculpted).toBe(sculpted)
      const heights = await grayOf(inSet('layers/expression/height.png'))
      expect(heights[SECOND]).toBeLessThan(100)
      expect(heights[LINE]).toBe(128)
      expect(heights[OFF]).toBeGreaterThan(200)
    })

    it('writes the same bytes when it draws again', async () => {
      await draw(DOCUMENT)
      const read = () =>
        ['wrinkles.json', 'layers/expression/blood.png'].map((name) => readFileSync(inSet(name)))
      const before = read()
      await draw(DOCUMENT)
      expect(read()).toEqual(before)
    })

    it('keeps areas, drivers, options and blood of a set when its strokes change', async () => {
      await draw(DOCUMENT)
      const blood = await grayOf(inSet('layers/expression/blood.png'))
      expect(blood[LINE]).toBeGreaterThan(128)
      blood[OFF] = 200
      writeFileSync(inSet('layers/expression/blood.png'), await grayPng(Uint8Array.from(blood), 32))
      const own = setDocument()
      own.layers[0].occlusionStrength = 0.5
      own.layers[0].bloodAmplitude = 0.2
      own.drivers = [{ type: 'morph', area: 'brow', targets: [{ name: 'browInnerUp', weight: 1 }] }]
      writeFileSync(inSet('wrinkles.json'), JSON.stringify(own))
      await draw(moved(0.25))
      const drawn = await grayOf(inSet('layers/expression/blood.png'))
      expect([drawn[LINE], drawn[OFF]]).toEqual([128, 200])
      expect(drawn[SECOND]).toBe(blood[LINE])
      expect(setDocument()).toMatchObject({
        layers: [{ occlusionStrength: 0.5, bloodAmplitude: 0.2 }],
        areas: own.areas,
        drivers: own.drivers,
      })
    })

    it('draws each layer of a document, and no heights of fine furrows', async () => {
      const strokes = ['up', 'down'].map((layer, i) => ({
        ...moved(0.25 + 0.5 * i).strokes[0],
        layer,
        group: layer,
      }))
      await draw({ version: 1, strokes, furrows: { layer: 'net' } })
      const { layers, areas } = setDocument()
      expect(layers.map(({ name, height }: { name: string; height?: string }) => [name, height])).toEqual([
        ['up', 'layers/up/height.png'],
        ['down', 'layers/down/height.png'],
        ['net', undefined],
      ])
      expect(areas.map(({ name, layer }: { name: string; layer: string }) => [name, layer])).toEqual([
        ['up', 'up'],
        ['down', 'down'],
      ])
      expect((await grayOf(inSet('layers/down/height.png')))[SECOND]).toBe(128)
      const before = readFileSync(inSet('layers/up/normal.png'))
      await draw(
        { version: 1, strokes: strokes.map((stroke) => ({ ...stroke, depth: 1 })) },
        '--layer',
        'down',
      )
      expect(readFileSync(inSet('layers/up/normal.png'))).toEqual(before)
      await expect(draw(DOCUMENT)).rejects.toThrow(
        'furrow strokes: strokes[0] names no layer, allowed: up, down, net; name one of them in the document',
      )
      const typed = { version: 1, strokes: [{ ...strokes[0], layer: 'dwon' }] }
      await expect(draw(typed)).rejects.toThrow('the folder has no such layer, got "dwon"')
    })

    it('fails and writes nothing', async () => {
      const unsupported = draw(DOCUMENT, '--size', '65')
      await expect(unsupported).rejects.toThrow(
        'the size is odd, but heights, occlusion and blood have half this size, got 65, allowed: even sizes; choose --size 66',
      )
      await expect(draw(DOCUMENT, '--detail')).rejects.toThrow("'--into <folder>' cannot be used with")
      expect(existsSync(set)).toBe(false)
      await draw(DOCUMENT)
      await expect(draw(DOCUMENT, '--size', '128')).rejects.toThrow(
        /so painted blood cannot be kept, got "?32 x 32/,
      )
      const before = '{ "layers": 3 }'
      writeFileSync(inSet('wrinkles.json'), before)
      await expect(draw(DOCUMENT)).rejects.toThrow(/set\/wrinkles\.json: layers/)
      expect(readFileSync(inSet('wrinkles.json'), 'utf8')).toBe(before)
    })
  })

  it.each<[string, string, () => string[]]>([
    ['no output', 'no output, allowed: -o HEIGHT.png', () => [strokes, '--face', face]],
    [
      'a mesh that is not there',
      `no such mesh in ${face}, got "nose", allowed: sheet; name one with --mesh`,
      () => [strokes, '--face', face, '--mesh', 'nose', '-o', file('x.png')],
    ],
    [
      'several meshes',
      `several meshes in ${file('two.glb')}, allowed: left, right; name one with --mesh`,
      () => [strokes, '--face', file('two.glb'), '-o', file('x.png')],
    ],
    [
      'a base that is not an image',
      'strokes.json (it is text), allowed: PNG, JPEG, WebP or AVIF; choose an image',
      () => [strokes, '--face', face, '--base', strokes, '--normal', file('x.png')],
    ],
  ])('fails for %s and writes nothing', async (_, message, args) => {
    await writeFace(file('two.glb'), ['left', 'right'])
    await at.fails(message, ...args())
  })
})
