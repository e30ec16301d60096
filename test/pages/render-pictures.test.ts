import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { draco } from '@gltf-transform/functions'
import sharp from 'sharp'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import type { PictureRequest } from '../../packages/cli/src/render/picture.ts'
import type { Picture } from '../../packages/cli/src/render/render-pictures.ts'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { editGlb } from '../glb.ts'
import { CHIN, FOREHEAD, largestDifference, meanDifference, type Region, WHOLE } from './pixels.ts'
import type { CanvasPixels } from './read-canvas.ts'
import { type CommandResult, renderPictures, runFurrow } from './run-furrow.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FACE = join(ROOT, 'faces/human.glb')

/** Region of the cheeks and the mouth. */
const FOLDS: Region = { left: 0.35, top: 0.45, right: 0.65, bottom: 0.65 }

let folder: string

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'furrow-render-'))
})

afterAll(() => rm(folder, { recursive: true, force: true }))

/** Options of most pictures. Relief takes seconds to prepare, so only some pictures have it. */
const FLAT = { width: 200, height: 152, relief: 'off' } as const
const SURPRISED = { ...FLAT, expression: 'surprised' } as const
/** Size at which a millimetre of skin is wider than a pixel, so relief appears by default. */
const NEAR = { width: 480, height: 360 }
const HAPPY = { ...FLAT, expression: 'happy' } as const

/** Options that raise the brows. Drivers in the file read `browInnerUp`. */
const RAISED = { ...FLAT, targets: { browInnerUp: 1 } }

/** Options that only one request sets. Later requests must not keep them. */
const ANGRY: Partial<PictureRequest> = {
  mode: 'composed',
  view: 'close',
  expression: 'angry',
  targets: { mouthPucker: 1 },
  activations: { nose: 1 },
}

describe('pictures of furrow render', () => {
  /** Pictures by name. Requests with the same face follow each other, because opening another face takes most of the time. */
  const drawn = new Map<string, Picture>()

  beforeAll(async () => {
    const [images, arrays, compressed] = ['images', 'arrays', 'draco'].map((name) =>
      join(folder, `${name}.glb`),
    )
    await pack(images)
    await pack(arrays, '--ktx2')
    await transformFile(arrays, compressed, [draco({ quantizePosition: 16 })])
    const bare = join(folder, 'bare.glb')
    await writeFile(bare, editGlb(await readFile(FACE), strip))
    const plain = join(folder, 'plain.vrm')
    await writeFile(plain, editGlb(await readFile(FACE), removeWrinkles))
    const slow = join(folder, 'slow.glb')
    await writeFile(slow, editGlb(await readFile(images), delay))
    const aged = join(folder, 'aged.glb')
    await writeFile(aged, editGlb(await readFile(images), age))
    const text = await writeGltf(slow)
    const set = await writeSet()
    const wide = { input: images, mode: 'off', view: 'front' } as const
    const requests: Record<string, PictureRequest> = {
      'webgl images': { input: images, ...SURPRISED },
      'webgl off': { input: images, ...SURPRISED, mode: 'off' },
      'webgl large': { ...wide, width: 2112, height: 96 },
      'webgl small': { ...wide, width: 1056, height: 48 },
      'webgl angry': { ...wide, ...ANGRY, width: 96, height: 96 },
      'webgl driven': { input: images, ...RAISED },
      'webgl aged': { input: aged, ...FLAT },
      'webgl aged neutral': { input: aged, ...FLAT, expression: 'neutral' },
      'webgl aged off': { input: aged, ...FLAT, mode: 'off' },
      'webgl again': { input: images, ...SURPRISED },
      'webgl KTX 2 arrays and Draco': { input: compressed, ...SURPRISED },
      'webgl bare': { input: bare, ...HAPPY },
      'webgl bare off': { input: bare, ...HAPPY, mode: 'off' },
      'webgl plain': { input: plain, ...SURPRISED },
      'webgl set': { input: plain, wrinkles: set, ...SURPRISED, relief: 'off' },
      'webgl relief': { input: plain, wrinkles: set, ...SURPRISED, relief: 'on' },
      'webgl relief by size': { input: plain, wrinkles: set, ...SURPRISED, relief: undefined },
      'webgl near': { input: plain, wrinkles: set, ...SURPRISED, ...NEAR, relief: undefined },
      'webgl near flat': { input: plain, wrinkles: set, ...SURPRISED, ...NEAR },
      'webgl text': { input: text, ...SURPRISED },
      'webgl delayed': { input: text, ...RAISED },
      'webgpu images': { input: images, ...SURPRISED, renderer: 'webgpu' },
      'webgpu off': { input: images, ...SURPRISED, renderer: 'webgpu', mode: 'off' },
      'webgpu KTX 2 arrays': { input: arrays, ...SURPRISED, renderer: 'webgpu' },
    }
    const names = Object.keys(requests)
    const pictures = await renderPictures(Object.values(requests))
    for (const [i, name] of names.entries()) drawn.set(name, pictures[i])
  })

  test('show wrinkles on webgpu too', () => {
    expect(largestDifference(opaque('webgpu images'), opaque('webgpu off'), FOREHEAD)).toBeGreaterThan(20)
    expect(largestDifference(opaque('webgpu images'), opaque('webgpu off'), CHIN)).toBe(0)
  })

  test.each([
    ['KTX 2 arrays and Draco', 'webgl'],
    ['KTX 2 arrays', 'webgpu'],
  ])('look the same with %s as with PNG images (%s)', (form, renderer) => {
    const [plain, smooth] = [opaque(`${renderer} images`), opaque(`${renderer} off`)]
    const compressed = drawn.get(`${renderer} ${form}`)!
    expect(compressed.warnings).toEqual([])
    const difference = meanDifference(opaque(`${renderer} ${form}`), plain, FOREHEAD)
    expect(difference).toBeLessThan(meanDifference(plain, smooth, FOREHEAD) / 3)
  })

  test('show a face without wrinkles like a face with wrinkles off, and report that it has none', () => {
    expect(drawn.get('webgl plain')!.warnings).toEqual([
      expect.stringMatching(/plain\.vrm has no wrinkles; add them with furrow auto$/),
    ])
    expect(largestDifference(opaque('webgl plain'), opaque('webgl off'), WHOLE)).toBeLessThanOrEqual(2)
  })

  test('show a wrinkle set with onset, occlusion and height maps, only in its area', () => {
    expect(drawn.get('webgl set')!.warnings).toEqual([])
    const [left, right] = [
      { ...FOREHEAD, left: 0.51 },
      { ...FOREHEAD, right: 0.49 },
    ]
    const differences = [left, right].map((half) =>
      largestDifference(opaque('webgl set'), opaque('webgl off'), half),
    )
    expect(differences[0]).toBeGreaterThan(20)
    expect(differences[1]).toBeLessThan(differences[0] / 2)
  })

  test('show delayed wrinkles in their final state', () => {
    expect(opaque('webgl delayed')).toEqual(opaque('webgl driven'))
    expect(largestDifference(opaque('webgl driven'), opaque('webgl off'), FOREHEAD)).toBeGreaterThan(20)
  })

  test('show the wrinkles of age both at rest and in an expression', () => {
    expect(opaque('webgl aged neutral')).toEqual(opaque('webgl aged'))
    expect(
      largestDifference(opaque('webgl aged neutral'), opaque('webgl aged off'), FOREHEAD),
    ).toBeGreaterThan(20)
  })

  test('show a .gltf and its separate files like the .glb', () => {
    expect(opaque('webgl text')).toEqual(opaque('webgl images'))
  })

  test('do not depend on earlier pictures', () => {
    expect(drawn.get('webgl angry')!.pixels.length).toBe(4 * 96 * 96)
    expect(opaque('webgl again')).toEqual(opaque('webgl images'))
  })

  test('show the areas of an expression that the face has, even if the face has no drivers', () => {
    const { warnings } = drawn.get('webgl bare')!
    expect(warnings).toEqual([expect.stringContaining('underEyeLeft, underEyeRight')])
    expect(largestDifference(opaque('webgl bare'), opaque('webgl bare off'), FOLDS)).toBeGreaterThan(20)
  })

  test('show a surface moved by the heights of a set if relief is on', () => {
    const [flat, raised] = [opaque('webgl set'), opaque('webgl relief')]
    expect(drawn.get('webgl relief')!.warnings).toEqual([])
    // The set has no area on the chin, so relief changes no byte there.
    expect(largestDifference(raised, flat, FOREHEAD)).toBeGreaterThan(3)
    expect(largestDifference(raised, flat, CHIN)).toBe(0)
  })

  test('show relief depending on the size on screen by default', () => {
    expect(opaque('webgl relief by size')).toEqual(opaque('webgl set'))
    expect(drawn.get('webgl near')!.pixels).not.toEqual(drawn.get('webgl near flat')!.pixels)
  })

  test('have no seams if drawn in several tiles', async () => {
    const { data, width, height } = opaque('webgl large')
    const large = sharp(data, { raw: { width, height, channels: 3 } })
    const reduced = await large.resize(1056, 48, { kernel: 'linear' }).raw().toBuffer()
    const { data: small } = opaque('webgl small')
    const mean = small.reduce((sum, value, i) => sum + Math.abs(value - reduced[i]), 0) / small.length
    expect(mean).toBeLessThan(1)
  })

  /** Returns a picture by name, without alpha. */
  function opaque(name: string): CanvasPixels {
    const { width, height, pixels } = drawn.get(name)!
    return { width, height, data: pixels.filter((_, i) => i % 4 < 3) }
  }
})

/**
 * Writes a wrinkle set with one area on the left half of the forehead, driven by one blendshape, with onset and heights, and with occlusion of
 * strength 0.
 */
async function writeSet(): Promise<string> {
  const own = join(folder, 'set')
  await cp(join(ROOT, 'faces/human'), own, { recursive: true })
  await cp(join(own, 'layers/expression/normal.png'), join(own, 'height.png'))
  const set = {
    layers: [
      {
        name: 'expression',
        kind: 'detail',
        occlusion: 'layers/expression/occlusion.png',
        occlusionStrength: 0,
        onset: 'layers/expression/onset.png',
        height: 'height.png',
        heightAmplitude: 0.01,
      },
    ],
    areas: [{ name: 'foreheadLeft' }],
    drivers: [{ type: 'morph', area: 'foreheadLeft', targets: [{ name: 'browOuterUpLeft', weight: 1 }] }],
  }
  await writeFile(join(own, 'wrinkles.json'), JSON.stringify(set))
  return join(own, 'wrinkles.json')
}

function pack(file: string, ...options: string[]): Promise<CommandResult> {
  const wrinkles = join(ROOT, 'faces/human')
  return runFurrow(folder, {}, 'pack', wrinkles, '--face', FACE, '--size', '512', '-o', file, ...options)
}

function removeWrinkles({
  materials,
}: {
  materials: { extensions?: { FURROW_wrinkle_maps?: unknown } }[]
}): void {
  for (const { extensions } of materials) delete extensions?.FURROW_wrinkle_maps
}

/** Writes a .glb as a .gltf with a separate buffer. */
async function writeGltf(glb: string): Promise<string> {
  const bytes = await readFile(glb)
  const end = 20 + bytes.readUInt32LE(12)
  const json = JSON.parse(bytes.toString('utf8', 20, end))
  json.buffers[0].uri = 'its%20buffer.bin'
  await writeFile(join(folder, 'its buffer.bin'), bytes.subarray(end + 8))
  await writeFile(join(folder, 'text.gltf'), JSON.stringify(json))
  return join(folder, 'text.gltf')
}

/** Removes all drivers, and the areas under the eyes. */
function strip(json: { materials: { extensions?: { FURROW_wrinkle_maps?: WrinkleMapsJson } }[] }): void {
  for (const { extensions } of json.materials) {
    const wrinkled = extensions?.FURROW_wrinkle_maps
    if (!wrinkled) continue
    delete wrinkled.drivers
    wrinkled.areas = wrinkled.areas.filter(({ name }) => !name.startsWith('underEye'))
  }
}

/** Adds drivers with an initial age of 70. They show wrinkles on the forehead of a face at rest. */
function age(json: { materials: { extensions?: { FURROW_wrinkle_maps?: WrinkleMapsJson } }[] }): void {
  const curve = [
    [20, 0],
    [70, 1],
  ]
  for (const { extensions } of json.materials)
    for (const area of ['foreheadLeft', 'foreheadRight'])
      extensions?.FURROW_wrinkle_maps?.drivers?.push({ type: 'age', area, curve, initial: 70 })
}

/** Adds drivers that activate every area with a delay of a minute. */
function delay(json: { materials: { extensions?: { FURROW_wrinkle_maps?: WrinkleMapsJson } }[] }): void {
  for (const { extensions } of json.materials) {
    const wrinkled = extensions?.FURROW_wrinkle_maps
    wrinkled?.drivers?.push(...wrinkled.areas.map(({ name }) => ({ type: 'time', area: name, attack: 60 })))
  }
}

interface WrinkleMapsJson {
  areas: { name: string }[]
  drivers?: object[]
}
