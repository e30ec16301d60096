import { existsSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Document, NodeIO } from '@gltf-transform/core'
import sharp from 'sharp'
import { afterAll, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { strokesCommand } from '../../../packages/cli/src/commands/strokes.ts'
import { accessorsOf } from '../../accessors.ts'
import { sheet } from './planes.ts'

const folder = mkdtempSync(join(tmpdir(), 'furrow-strokes-'))
const file = (name: string) => join(folder, name)
const face = file('face.glb')
const strokes = file('strokes.json')

const DOCUMENT = {
  version: 1,
  strokes: [
    {
      group: 'brow',
      points: [
        [0.1, 0.5],
        [0.9, 0.5],
      ],
      width: 4,
      depth: 0.5,
      taper: 0,
    },
  ],
}

/** Writes a sheet of 100 x 100 mm per name as a glTF file; the last one gets a tilted normal map. */
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

const run = (...args: string[]) => strokesCommand.parseAsync(args, { from: 'user' })

let printed = ''

beforeAll(async () => {
  await writeFace(face, ['sheet'])
  writeFileSync(strokes, JSON.stringify(DOCUMENT))
})

beforeEach(() => {
  printed = ''
  vi.spyOn(process.stdout, 'write').mockImplementation((text) => {
    printed += text
    return true
  })
})

afterAll(() => {
  vi.restoreAllMocks()
  rmSync(folder, { recursive: true })
})

describe('furrow strokes', () => {
  it('writes the height map in 16 bits and says its scale', async () => {
    await run(strokes, '--face', face, '-o', file('height.png'), '--size', '201')
    expect(printed).toContain('height.png: 201 x 201, 16-bit, 32768 = 0 mm, 1 step = 0.001 mm, -0.50..')
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

  it('lays the wrinkles over the normal map of the mesh and leaves it alone elsewhere', async () => {
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

  it('writes the areas in the convention of the paper', async () => {
    await run(strokes, '--face', face, '--areas', file('areas'))
    expect(readdirSync(file('areas'))).toEqual(['brow.png'])
    const image = sharp(file('areas/brow.png'))
    expect(await image.metadata()).toMatchObject({ width: 128, height: 128, channels: 1, depth: 'uchar' })
    const gray = await image.toColourspace('b-w').raw().toBuffer()
    expect(gray[64 * 128 + 64]).toBe(0)
    expect(gray[0]).toBe(255)
  })

  it.each([
    ['no output', () => [strokes, '--face', face], 'no output, allowed: -o HEIGHT.png'],
    [
      'no such document',
      () => [file('none.json'), '--face', face, '-o', file('x.png')],
      'cannot read the strokes',
    ],
    [
      'no such face',
      () => [strokes, '--face', file('none.glb'), '-o', file('x.png')],
      'cannot read the face',
    ],
    [
      'a face that is not glTF',
      () => [strokes, '--face', strokes, '-o', file('x.png')],
      'is not usable: its JSON has no asset.version',
    ],
    [
      'a mesh that is not there',
      () => [strokes, '--face', face, '--mesh', 'nose', '-o', file('x.png')],
      `no such mesh in ${face}, got "nose", allowed: sheet; name one with --mesh`,
    ],
    [
      'a size that is not a number',
      () => [strokes, '--face', face, '--size', '1k', '-o', file('x.png')],
      "option '--size <texels>' argument '1k' is invalid. It must be an integer from 16 to 8192 texels; see furrow strokes --help",
    ],
    [
      'a base that is not an image',
      () => [strokes, '--face', face, '--base', strokes, '--normal', file('x.png')],
      'strokes.json (it is text), allowed: PNG, JPEG, WebP or AVIF; name an image',
    ],
    [
      'a folder instead of a file',
      () => [strokes, '--face', face, '-o', folder, '--normal', file('x.png'), '--size', '32'],
      'cannot write',
    ],
  ])('says what is wrong with %s and writes nothing', async (_, args, message) => {
    const before = readdirSync(folder).sort()
    const failure = await run(...args()).then(
      () => undefined,
      (error: Error) => error,
    )
    expect(failure?.name).toBe('FurrowError')
    expect(failure?.message).toContain(`furrow strokes: `)
    expect(failure?.message).toContain(message)
    expect(failure?.message).not.toContain('\n')
    expect(existsSync(file('x.png'))).toBe(false)
    expect(readdirSync(folder).sort()).toEqual(before)
  })

  it('asks for a mesh where there are several', async () => {
    await writeFace(file('two.glb'), ['left', 'right'])
    await expect(run(strokes, '--face', file('two.glb'), '-o', file('x.png'))).rejects.toThrow(
      `furrow strokes: several meshes in ${file('two.glb')}, allowed: left, right; name one with --mesh`,
    )
  })
})
