import { readFileSync, writeFileSync } from 'node:fs'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { degreesBetween, plus, unit, type Vector, vectorAt } from '../../vectors.ts'
import { readPixels } from './exact-sphere.ts'
import { bench } from './workshop.ts'

const at = bench('normals')
const { file, run } = at

/** Width of the picture, millimetres. Positions are relative to its centre, y up. */
const WIDE = 100
/** Height difference between black and white, millimetres. */
const DEEP = 20
const SIDE = 257

/** Heights, 0 to 20 mm, and their exact normals, not normalised. `inside` is false at points without a normal. */
const SHAPES = {
  plane: {
    height: (x: number, y: number) => 10 + 0.12 * x - 0.05 * y,
    normal: (): Vector => [-0.12, 0.05, 1],
    inside: () => true,
  },
  // A spherical cap with a radius of 60 mm and a height of 15 mm. Its rim has no unique normal.
  cap: {
    height: (x: number, y: number) => Math.max(Math.sqrt(3600 - x * x - y * y) - 45, 0),
    normal: (x: number, y: number): Vector => [x, y, Math.sqrt(3600 - x * x - y * y)],
    inside: (x: number, y: number) => Math.hypot(x, y) < 38.5,
  },
  // Two waves across and three down, so that the picture repeats without seams.
  sine: {
    height: (x: number, y: number) => 10 + 4 * Math.sin(2 * WAVE * x + 1) + 5 * Math.cos(3 * WAVE * y),
    normal: (x: number, y: number): Vector => [
      -8 * WAVE * Math.cos(2 * WAVE * x + 1),
      15 * WAVE * Math.sin(3 * WAVE * y),
      1,
    ],
    inside: () => true,
  },
} as const
const WAVE = (2 * Math.PI) / WIDE

const place = (column: number, row: number, side: number): [number, number] => [
  ((column + 0.5) / side - 0.5) * WIDE,
  (0.5 - (row + 0.5) / side) * WIDE,
]

async function writeHeight(path: string, height: (x: number, y: number) => number, side = SIDE, bits = 16) {
  const full = 2 ** bits - 1
  const values = Array.from({ length: side * side }, (_, i) =>
    Math.round((height(...place(i % side, Math.floor(i / side), side)) / DEEP) * full),
  )
  const data = bits === 16 ? Uint16Array.from(values) : Uint8Array.from(values)
  const image = sharp(data, { raw: { width: side, height: side, channels: 1 } })
  // Sets the compression, because by default sharp writes a TIFF with 8-bit JPEG.
  if (path.endsWith('.tif')) image.tiff({ compression: 'lzw' })
  await image.toColourspace(bits === 16 ? 'grey16' : 'b-w').toFile(path)
}

/** Decodes a normal map to unit normals with y up. `green` is the direction of the green channel: `up` or `down`. */
async function readNormals(path: string, green: string): Promise<Vector[]> {
  const { values, channels, full } = await readPixels(path)
  expect(channels).toBe(3)
  return Array.from({ length: values.length / 3 }, (_, i) => {
    const [x, y, z] = vectorAt(values, i).map((value) => (2 * value) / full - 1)
    return unit([x!, green === 'up' ? y! : -y!, z!])
  })
}

async function worst(path: string, shape: (typeof SHAPES)[keyof typeof SHAPES], green: string) {
  const normals = await readNormals(path, green)
  const side = Math.sqrt(normals.length)
  const angles = normals.map((normal, i) => {
    const [x, y] = place(i % side, Math.floor(i / side), side)
    return shape.inside(x, y) ? degreesBetween(normal, shape.normal(x, y)) : 0
  })
  return Math.max(...angles)
}

/** Makes a TIFF with one texel of 32-bit floating point, as sculpting programs write (TIFF 6.0, section 2). */
function floatTiff(): Uint8Array {
  const tags = [
    [256, 1],
    [257, 1],
    [258, 32],
    [259, 1],
    [262, 1],
    [273, 134],
    [277, 1],
    [278, 1],
    [279, 4],
    [339, 3],
  ]
  const bytes = new DataView(new ArrayBuffer(138))
  bytes.setUint32(0, 0x49492a00)
  bytes.setUint32(4, 8, true)
  bytes.setUint16(8, 10, true)
  for (const [i, [tag, value]] of tags.entries()) {
    bytes.setUint16(10 + 12 * i, tag!, true)
    bytes.setUint16(12 + 12 * i, 3, true)
    bytes.setUint32(14 + 12 * i, 1, true)
    bytes.setUint16(18 + 12 * i, value!, true)
  }
  bytes.setFloat32(134, 0.5, true)
  return new Uint8Array(bytes.buffer)
}

beforeAll(async () => {
  for (const [name, { height }] of Object.entries(SHAPES)) await writeHeight(file(`${name}.png`), height)
  await writeHeight(file('sine.tif'), SHAPES.sine.height)
  await writeHeight(file('small.png'), SHAPES.plane.height, 8)
})

describe('furrow normals', () => {
  it.each([
    ['plane', 'clamp', 'up', '8', 0.33],
    ['plane', 'clamp', 'down', '16', 0.1],
    ['cap', 'clamp', 'up', '8', 0.4],
    ['cap', 'wrap', 'down', '8', 0.4],
    ['cap', 'clamp', 'up', '16', 0.06],
    ['sine', 'wrap', 'up', '8', 0.4],
    ['sine', 'wrap', 'down', '16', 0.05],
    ['sine', 'clamp', 'down', '8', 0.5],
  ] as const)(
    '%s, edges %s, green %s, %s bits: within %f degrees',
    async (name, edges, green, bits, limit) => {
      const out = file(`${name}-${edges}-${green}-${bits}.png`)
      const strength = ['--depth', `${DEEP}`, '--width', `${WIDE}`]
      const kind = ['--edges', edges, '--green', green, '--bits', bits]
      await run(file(`${name}.png`), '-o', out, ...strength, ...kind, '--json')
      const size = { width: SIDE, height: SIDE }
      expect(JSON.parse(at.printed)).toMatchObject({ file: out, ...size, bits: Number(bits), green })
      expect(await worst(out, SHAPES[name], green)).toBeLessThan(limit)
      const other = green === 'up' ? 'down' : 'up'
      expect(await worst(out, SHAPES[name], other)).toBeGreaterThan(5)
    },
  )

  it('reads 16-bit TIFF, and accepts the strength in texels instead of millimetres', async () => {
    const texels = (DEEP / WIDE) * SIDE
    await run(file('sine.tif'), '-o', file('tif.png'), '--strength', `${texels}`, '--edges', 'wrap')
    expect(await worst(file('tif.png'), SHAPES.sine, 'up')).toBeLessThan(0.4)
    expect(at.printed).toContain(`tif.png: ${SIDE} x ${SIDE}, 8 bits, green up, steepest slope `)
    expect(at.warned).toBe('')
  })

  it('reads 8 bits and gray stored as colour, and warns about 8 bits', async () => {
    await writeHeight(file('byte.png'), SHAPES.plane.height, 64, 8)
    await sharp(file('byte.png')).toColourspace('srgb').toFile(file('rgb.png'))
    for (const name of ['byte', 'rgb']) {
      await run(file(`${name}.png`), '-o', file(`${name}-n.png`), '--depth', '20', '--width', '100')
      expect(at.warned).toContain('has only 8 bits, so gentle slopes show steps; use a 16-bit height map')
    }
    const [normals, fromRgb] = await Promise.all(
      ['byte', 'rgb'].map((name) => readNormals(file(`${name}-n.png`), 'up')),
    )
    expect(fromRgb).toEqual(normals)
    const mean = normals.reduce((sum, n) => plus(sum, n))
    expect(degreesBetween(mean, SHAPES.plane.normal())).toBeLessThan(0.5)
  })

  it('turns bumps into dents with a negative strength', async () => {
    await run(file('small.png'), '-o', file('out.png'), '--strength', '4')
    await run(file('small.png'), '-o', file('in.png'), '--strength', '-4')
    const [out] = await readNormals(file('out.png'), 'up')
    const [turned] = await readNormals(file('in.png'), 'up')
    expect(degreesBetween([-out![0], -out![1], out![2]], turned!)).toBeLessThan(0.7)
    expect(out![0]).toBeLessThan(-0.01)
  })

  describe('fails and writes nothing for', () => {
    beforeAll(async () => {
      writeFileSync(file('text.png'), 'not an image')
      const intact = readFileSync(file('plane.png'))
      writeFileSync(file('cut.png'), intact.subarray(0, intact.length / 2))
      await sharp({ create: { width: 9, height: 9, channels: 3, background: '#8080ff' } }).toFile(
        file('blue.png'),
      )
      writeFileSync(file('float.tif'), floatTiff())
      await sharp({ create: { width: 8193, height: 1, channels: 3, background: '#888' } }).toFile(
        file('wide.png'),
      )
    })

    it.each([
      ['text.png', 'it is text'],
      ['cut.png', 'cannot read the image'],
      ['blue.png', 'got "128, 128, 255 at 0, 0", allowed: gray heights'],
      ['float.tif', 'got "float", allowed: 8 or 16 bits per channel'],
      ['wide.png', 'got "8193 x 1", allowed: 8192 texels per side'],
    ])('%s as input', (name, message) =>
      at.fails(message, file(name), '-o', file('x.png'), '--strength', '5'),
    )

    it.each([
      [
        [],
        'the depth of the height map is missing, allowed: --depth MM with --width MM, or --strength TEXELS',
      ],
      [['--depth', '2'], 'the depth of the height map is missing, allowed'],
      [
        ['--depth', '2', '--width', '100', '--strength', '3'],
        "option '--strength <texels>' cannot be used with option '--depth <mm>'",
      ],
    ])('%j', (args, message) => at.fails(message, file('small.png'), '-o', file('x.png'), ...args))
  })
})
