import { readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import {
  KHR_SUPERCOMPRESSION_ZSTD,
  read,
  VK_FORMAT_R8_UNORM,
  VK_FORMAT_R8G8B8A8_SRGB,
  write,
} from 'ktx-parse'
import sharp from 'sharp'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { beforeAll, describe, expect, it } from 'vitest'
import { NAMES_KEY } from '../../../packages/files/src/ktx2/ktx2.ts'
import { seeded } from '../../random.ts'
import { bench } from './workshop.ts'

const at = bench('array')
const { file, run } = at

const [WIDE, HIGH] = [24, 16]

/** Returns pixels of smooth colours, which compress well. Each layer has other colours. */
function paint(layer: number, channels: 1 | 3 | 4): Uint8Array {
  const random = seeded(layer)
  const [a, b, c] = [random(), random(), random()]
  return Uint8Array.from({ length: WIDE * HIGH * channels }, (_, i) => {
    const [x, y] = [(Math.floor(i / channels) % WIDE) / WIDE, Math.floor(i / channels / WIDE) / HIGH]
    return [255 * (a * x + (1 - a) * y), 255 * (b * y), 200 * c + 55 * x, 128 + 100 * x][i % channels]!
  })
}

async function picture(name: string, layer: number, channels: 1 | 3 | 4): Promise<string> {
  const image = sharp(paint(layer, channels), { raw: { width: WIDE, height: HIGH, channels } })
  await image.toColourspace(channels === 1 ? 'b-w' : 'srgb').toFile(file(name))
  return file(name)
}

async function pixels(path: string) {
  const image = sharp(path)
  const { channels } = await image.metadata()
  if (channels === 1) image.toColourspace('b-w')
  return { data: new Uint8Array(await image.raw().toBuffer()), channels }
}

const open = (name: string) => read(new Uint8Array(readFileSync(file(name))))

/** Loads a KTX 2 file with three.js, as for a GPU that supports no compressed textures. */
async function load(name: string) {
  const loader = new KTX2Loader() as unknown as {
    workerConfig: object
    _createTexture(
      bytes: ArrayBuffer,
    ): Promise<{ image: { data: Uint8Array; width: number; height: number } }>
  }
  loader.workerConfig = {}
  const bytes = readFileSync(file(name))
  return loader._createTexture(
    bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length) as ArrayBuffer,
  )
}

const RGBA32 = 13

interface ThreeTranscoder {
  initializeBasis(): void
  KTX2File: new (
    bytes: Uint8Array,
  ) => {
    isValid(): boolean
    getLayers(): number
    getLevels(): number
    startTranscoding(): number
    getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number
    transcodeImage(out: Uint8Array, level: number, layer: number, face: number, ...rest: number[]): number
    close(): void
    delete(): void
  }
}

/** Loads the WebAssembly transcoder of KTX2Loader, which in browsers runs in web workers. */
async function transcoder(): Promise<ThreeTranscoder> {
  const folder = new URL('../../../node_modules/three/examples/jsm/libs/basis/', import.meta.url)
  const script = readFileSync(new URL('basis_transcoder.js', folder), 'utf8')
  const start = new Function('require', '__dirname', `${script}; return BASIS`)(
    createRequire(import.meta.url),
    '',
  ) as (options: object) => Promise<ThreeTranscoder>
  return start({ wasmBinary: readFileSync(new URL('basis_transcoder.wasm', folder)) })
}

let gray: string[]
let colour: string[]

beforeAll(async () => {
  gray = await Promise.all([0, 1, 2].map((i) => picture(`brow ${i}.png`, i, 1)))
  colour = [await picture('skin.png', 3, 3), await picture('veil.png', 4, 4), gray[0]!]
})

describe('furrow array', () => {
  it.each(['none', 'zstd'])('returns gray images bit for bit, %s', async (compress) => {
    await run(...gray, '-o', file(`${compress}.ktx2`), '--compress', compress)
    expect(at.printed).toContain(`${compress}.ktx2: 3 layers of 24 x 16, gray, ${compress}, `)
    const { vkFormat, layerCount, pixelDepth, levelCount } = open(`${compress}.ktx2`)
    expect([vkFormat, layerCount, pixelDepth, levelCount]).toEqual([VK_FORMAT_R8_UNORM, 3, 0, 1])
    await run(file(`${compress}.ktx2`), '--extract', file(compress), '--json')
    expect(JSON.parse(at.printed.trim().split('\n')[1]!).layers).toEqual(['brow 0', 'brow 1', 'brow 2'])
    for (const [i, path] of gray.entries()) {
      const { data, channels } = await pixels(file(`${compress}/brow ${i}.png`))
      expect(channels).toBe(1)
      expect(data).toEqual((await pixels(path)).data)
    }
  })

  it('extracts colour, transparent and gray images from one array, each of its kind', async () => {
    await run(...colour, '-o', file('colour.ktx2'), '--srgb', '--json')
    expect(JSON.parse(at.printed)).toMatchObject({
      layers: ['skin', 'veil', 'brow 0'],
      channels: 4,
      srgb: true,
      compression: 'zstd',
      gpuBytes: 3 * 4 * WIDE * HIGH,
      bytes: readFileSync(file('colour.ktx2')).length,
    })
    expect(open('colour.ktx2')).toMatchObject({
      vkFormat: VK_FORMAT_R8G8B8A8_SRGB,
      supercompressionScheme: KHR_SUPERCOMPRESSION_ZSTD,
    })
    await run(file('colour.ktx2'), '--extract', file('colour'))
    expect(await pixels(file('colour/skin.png'))).toEqual({ data: paint(3, 3), channels: 3 })
    expect(await pixels(file('colour/veil.png'))).toEqual({ data: paint(4, 4), channels: 4 })
    const { data } = await pixels(file('colour/brow 0.png'))
    expect(data.filter((_, i) => i % 3 === 1)).toEqual(paint(0, 1))
    // An array made of the extracted images is the same file.
    const again = ['skin', 'veil', 'brow 0'].map((name) => file(`colour/${name}.png`))
    await run(...again, '-o', file('again.ktx2'), '--srgb')
    expect(readFileSync(file('again.ktx2')).equals(readFileSync(file('colour.ktx2')))).toBe(true)
  })

  it.each([
    ['uastc', 3],
    ['etc1s', 10],
  ] as const)('compresses for the GPU with %s, with little loss', async (compress, error) => {
    const images = [colour[0]!, gray[1]!, gray[2]!]
    await run(...images, '-o', file(`${compress}.ktx2`), '--compress', compress)
    expect(open(`${compress}.ktx2`)).toMatchObject({
      vkFormat: 0,
      layerCount: 3,
      pixelDepth: 0,
      levelCount: 5,
    })
    await run(...images, '-o', file(`${compress}-1.ktx2`), '--compress', compress, '--no-mipmaps', '--json')
    expect(open(`${compress}-1.ktx2`).levelCount).toBe(1)
    const { gpuBytes } = JSON.parse(at.printed.trim().split('\n')[1]!)
    expect(gpuBytes).toBe(3 * WIDE * HIGH * (compress === 'uastc' ? 1 : 0.5))
    await run(file(`${compress}.ktx2`), '--extract', file(compress))
    for (const [i, name] of ['skin', 'brow 1', 'brow 2'].entries()) {
      const { data, channels } = await pixels(file(`${compress}/${name}.png`))
      const { data: before } = await sharp(images[i])
        .toColourspace('srgb')
        .raw()
        .toBuffer({ resolveWithObject: true })
      expect(channels).toBe(3)
      const squares = data.reduce((sum, value, k) => sum + (value - before[k]!) ** 2, 0)
      expect(Math.sqrt(squares / data.length)).toBeLessThan(error)
    }
  })

  it.each(['none', 'zstd'])(
    "opens in three.js's KTX2Loader, %s, with its layers in order",
    async (compress) => {
      await run(...gray, '-o', file('three.ktx2'), '--compress', compress)
      const { image } = await load('three.ktx2')
      expect([image.width, image.height]).toEqual([WIDE, HIGH])
      const layers = [0, 1, 2].flatMap((i) => [...paint(i, 1)])
      expect([...image.data]).toEqual(layers)
    },
  )

  it.each(['uastc', 'etc1s'])(
    "has layers and mipmaps that three.js's transcoder finds: %s",
    async (compress) => {
      await run(...gray, '-o', file('basis.ktx2'), '--compress', compress)
      await run(file('basis.ktx2'), '--extract', file(`basis-${compress}`))
      const { KTX2File, initializeBasis } = await transcoder()
      initializeBasis()
      const basis = new KTX2File(new Uint8Array(readFileSync(file('basis.ktx2'))))
      expect([basis.isValid(), basis.getLayers(), basis.getLevels()]).toEqual([true, 3, 5])
      expect(basis.startTranscoding()).toBeTruthy()
      for (let layer = 0; layer < 3; layer++) {
        for (let level = 0; level < 5; level++) {
          const out = new Uint8Array(basis.getImageTranscodedSizeInBytes(level, layer, 0, RGBA32))
          expect(basis.transcodeImage(out, level, layer, 0, RGBA32, 0, -1, -1)).toBeTruthy()
          if (level > 0) continue
          const { data } = await pixels(file(`basis-${compress}/brow ${layer}.png`))
          expect(out.filter((_, i) => i % 4 < 3)).toEqual(data)
        }
      }
      basis.close()
      basis.delete()
    },
  )

  it("reads other tools' arrays, without names", async () => {
    await run(...gray, '-o', file('foreign.ktx2'))
    const container = open('foreign.ktx2')
    delete container.keyValue[NAMES_KEY]
    writeFileSync(file('foreign.ktx2'), write(container))
    await run(file('foreign.ktx2'), '--extract', file('foreign'))
    expect((await pixels(file('foreign/layer-2.png'))).data).toEqual(paint(2, 1))
  })
})

describe('furrow array fails and writes nothing for', () => {
  beforeAll(async () => {
    await run(...gray, '-o', file('good.ktx2'))
    await run(...gray, '-o', file('good-none.ktx2'), '--compress', 'none')
    await run(gray[0]!, colour[0]!, '-o', file('good-uastc.ktx2'), '--compress', 'uastc')
    await run(gray[0]!, colour[0]!, '-o', file('good-etc1s.ktx2'), '--compress', 'etc1s')
    const flat = { width: 30, height: 16, channels: 3 as const, background: '#123456' }
    await sharp({ create: flat }).toFile(file('wide.png'))
    await sharp({ create: flat }).toColourspace('rgb16').png().toFile(file('deep.png'))
    await sharp({ create: { ...flat, width: 4000, height: 4000 } }).toFile(file('huge.png'))
    writeFileSync(file('text.png'), 'no image')
    writeFileSync(
      file('text.ktx2'),
      'no array at all, but long enough to hold a header of a KTX 2 file'.repeat(4),
    )
    const container = open('good.ktx2')
    for (const [name, text] of Object.entries({
      climb: '["../a","b","c"]',
      twice: '["a","a","c"]',
      few: '["a"]',
      torn: '["a',
    })) {
      container.keyValue[NAMES_KEY] = text
      writeFileSync(file(`${name}.ktx2`), write(container))
    }
  })

  it.each([
    ['no image', ['text.png'], [], 'cannot read the image'],
    ['other sizes', ['skin.png', 'wide.png'], [], `got "30 x 16", allowed: 24 x 16, the size of `],
    ['16 bits', ['deep.png'], [], 'got "ushort", allowed: 8 bits per channel'],
    ['one name twice', ['skin.png', 'skin.png'], [], 'two layers with the same name, got "skin"'],
    ['257 images', Array<string>(257).fill('skin.png'), [], 'got 257, allowed: 1 to 256'],
    ['uneven blocks', ['wide.png'], ['--compress', 'uastc'], 'allowed: multiples of 4 texels'],
    ['too much', ['huge.png'], ['--compress', 'etc1s'], 'too many texels for this compression'],
  ])('%s', (_, images, options, message) =>
    at.fails(message, ...images.map(file), '-o', file('x.ktx2'), ...options),
  )

  it.each<readonly [string, string[], string[], string]>([
    ['no task', ['skin.png'], [], 'no output, allowed: IMAGES -o ARRAY.ktx2, or'],
    ['two arrays', ['good.ktx2', 'good.ktx2'], ['--extract', 'x'], 'got 2, allowed: 1; extract one'],
    ['no array', ['text.ktx2'], ['--extract', 'x'], 'cannot read the array'],
    ...['climb', 'twice', 'few', 'torn'].map((name): [string, string[], string[], string] => {
      return [name, [`${name}.ktx2`], ['--extract', 'x'], 'does not have 3 different names']
    }),
  ])('%s', (_, files, options, message) => at.fails(message, ...files.map(file), ...options))

  it.each(['good', 'good-none', 'good-uastc', 'good-etc1s'])('%s truncated anywhere', async (name) => {
    const intact = readFileSync(file(`${name}.ktx2`))
    for (let percent = 0; percent < 100; percent += 4) {
      writeFileSync(file('short.ktx2'), intact.subarray(0, Math.floor((intact.length * percent) / 100)))
      await at.fails('cannot read the array', file('short.ktx2'), '--extract', file('x'))
    }
  })
})
