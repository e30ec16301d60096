import { beforeAll, describe, expect, it } from 'vitest'
import { Evaluated, normalSteps, someTexels } from '../../imports/evaluate.ts'
import { CREASES, ExpressionSourceFiles } from '../../imports/expression-source.ts'
import { creased, normalPng } from '../../imports/paint.ts'
import { planeFace } from '../../imports/plane-face.ts'
import { seeded } from '../../random.ts'
import { bench, wrinklesIn } from '../cli/workshop.ts'

const tool = bench('import')
const SIZE = 256
const source = new ExpressionSourceFiles(SIZE)
const names = Object.keys(CREASES)
const texels = someTexels(SIZE, 3000)

/** Writes files to a folder and returns its path. */
function writeAll(folder: string, files: Record<string, Uint8Array>): string {
  for (const [name, bytes] of Object.entries(files)) tool.shop.write(`${folder}/${name}`, bytes)
  return tool.file(folder)
}

beforeAll(async () => {
  writeAll('maps', await source.files())
  const normalMap = await normalPng(source.neutral)
  tool.shop.write('face.glb', await planeFace(names, { normalMap }))
  tool.shop.write('bare.glb', await planeFace([]))
})

describe('furrow import of expression maps', () => {
  it('shows the sum of differences within 2 of 255 in 20 poses', async () => {
    await tool.run(tool.file('maps'), '--face', tool.file('face.glb'), '-o', tool.file('out.glb'))
    const shown = await Evaluated.of(tool.file('out.glb'))
    const random = seeded(48)
    const steps = Array.from({ length: 20 }, () => {
      const [brow, which] = [random(), random()]
      // Brows rise or frown. The weights of both may add up to 1.
      const pose = {
        surprise: brow * which,
        anger: brow * (1 - which),
        smileLeft: random(),
        smileRight: random(),
      }
      return normalSteps(shown.shade(pose, texels).normals, source.shade(pose))
    })
    expect(Math.max(...steps)).toBeLessThanOrEqual(2)
    // A wrong layer, area or driver would differ by much more.
    expect(normalSteps(shown.shade({}, texels).normals, source.shade({ surprise: 1 }))).toBeGreaterThan(30)
  })

  it('makes an area per group of wrinkles, and a layer per overlap', () => {
    const { layers, areas, drivers } = wrinklesIn(tool.file('out.glb'))
    expect(areas.map(({ name }: { name: string }) => name)).toEqual([
      'anger 1',
      'anger 2',
      'smileLeft',
      'smileRight',
      'surprise',
    ])
    expect(layers).toHaveLength(2)
    const layerOf = (name: string) => areas.find((area: { name: string }) => area.name === name).layer ?? 0
    expect(layerOf('anger 1')).not.toBe(layerOf('surprise'))
    expect(drivers).toHaveLength(5)
  })
})

it('the neutral map becomes the normal map of a face without one', async () => {
  await tool.run(tool.file('maps'), '--face', tool.file('bare.glb'), '-o', tool.file('bare-out.glb'))
  expect(tool.printed).toContain('it got the neutral one')
  expect(tool.printed).toContain('lost: no blendshape is named like "surprise"')
  const shown = await Evaluated.of(tool.file('bare-out.glb'))
  const pose = { surprise: 0.7, smileLeft: 1 }
  expect(normalSteps(shown.shade(pose, texels).normals, source.shade(pose))).toBeLessThanOrEqual(2)
})

it('differences are added to the normals of a face with another normal map', async () => {
  const other = creased(SIZE, 7, [])
  tool.shop.write('other.glb', await planeFace(names, { normalMap: await normalPng(other) }))
  await tool.run(tool.file('maps'), '--face', tool.file('other.glb'), '-o', tool.file('other-out.glb'))
  const shown = await Evaluated.of(tool.file('other-out.glb'))
  const still = shown.shade({}, texels).normals
  const moved = shown.shade({ surprise: 1 }, texels).normals
  const corner = 3 * texels.at(-1)!
  expect(moved.slice(corner, corner + 3)).toEqual(still.slice(corner, corner + 3))
  expect(normalSteps(moved, source.shade({ surprise: 1 }))).toBeLessThan(20)
})

it('key frames of an expression follow each other', async () => {
  const [half, full] = [0.2, 0.5].map((slope) =>
    creased(SIZE, 1, [{ u: 0.5, v: 0.25, radius: 0.18, slope, turn: slope }]),
  )
  writeAll('keys', {
    'neutral.png': await normalPng(source.neutral),
    'surprise@0.5.png': await normalPng(half!),
    'surprise.png': await normalPng(full!),
  })
  await tool.run(tool.file('keys'), '--face', tool.file('face.glb'), '-o', tool.file('keys.glb'))
  const shown = await Evaluated.of(tool.file('keys.glb'))
  const at = (weight: number) => Object.fromEntries(shown.activations({ surprise: weight }))
  expect(at(0.25)).toEqual({ 'surprise 0.5': 0.5, 'surprise 1': 0 })
  expect(at(0.5)).toEqual({ 'surprise 0.5': 1, 'surprise 1': 0 })
  expect(at(0.75)).toEqual({ 'surprise 0.5': 0.5, 'surprise 1': 0.5 })
  expect(at(1)).toEqual({ 'surprise 0.5': 0, 'surprise 1': 1 })
})

it('a fifth overlapping expression loses where others are stronger, and the command says so', async () => {
  const creases = Object.fromEntries(
    ['a', 'b', 'c', 'd', 'e'].map((name, i) => [
      name,
      [{ u: 0.5, v: 0.5, radius: 0.15, slope: 0.2 + 0.1 * i, turn: i }],
    ]),
  )
  writeAll('five', await new ExpressionSourceFiles(SIZE, creases).files())
  await tool.run(tool.file('five'), '--face', tool.file('face.glb'), '-o', tool.file('five.glb'))
  expect(wrinklesIn(tool.file('five.glb')).layers).toHaveLength(4)
  expect(tool.printed).toMatch(
    /lost: [ab]: \d+% of its area, where stronger wrinkles overlap it on all 4 layers/,
  )
})

it('of the blendshapes of a preset, only those that move an area drive it', async () => {
  const creases = { surprised: [{ u: 0.04, v: 0.04, radius: 0.12, slope: 0.4 }] }
  writeAll('preset', await new ExpressionSourceFiles(SIZE, creases).files())
  // The third blendshape moves the corner with the texture coordinates 0, 0.
  tool.shop.write('corners.glb', await planeFace(['jawOpen', 'browOuterUpLeft', 'browInnerUp']))
  await tool.run(tool.file('preset'), '--face', tool.file('corners.glb'), '-o', tool.file('preset.glb'))
  const { drivers } = wrinklesIn(tool.file('preset.glb'))
  expect(drivers.map(({ targets }: { targets: unknown }) => targets)).toEqual([
    [{ name: 'browInnerUp', weight: 1 }],
  ])
})

it('writes a folder that pack turns into the same wrinkles', async () => {
  await tool.run(tool.file('maps'), '--face', tool.file('face.glb'), '-o', tool.file('folder'))
  await tool.shop.run('pack', tool.file('folder'), '-o', tool.file('again.glb'))
  expect(wrinklesIn(tool.file('again.glb'))).toEqual(wrinklesIn(tool.file('out.glb')))
})

it('the document names targets, and unknown fields and files are listed', async () => {
  writeAll('listed', await source.files())
  tool.shop.write('listed/notes.txt', 'x')
  tool.shop.json('listed/expressions.json', {
    neutral: { normal: 'neutral.png' },
    expressions: [{ name: 'frown', normal: 'anger.png', targets: [{ name: 'anger', weight: 2 }], colour: 1 }],
    made: '2026',
  })
  await tool.run(
    tool.file('listed'),
    '--face',
    tool.file('face.glb'),
    '-o',
    tool.file('listed.glb'),
    '--json',
  )
  const { unread, areas } = JSON.parse(tool.printed)
  expect(unread).toEqual(['expressions.json: made', 'expressions.json: expressions[0].colour'])
  expect(areas).toEqual(['frown 1', 'frown 2'])
  const shown = await Evaluated.of(tool.file('listed.glb'))
  expect(shown.activations({ anger: 1 }).get('frown 1')).toBeCloseTo(0.5)
})

describe('furrow import refuses', () => {
  const refuses = (message: string | RegExp, folder: string, ...more: string[]) =>
    tool.fails(
      message,
      tool.file(folder),
      '--face',
      tool.file('face.glb'),
      '-o',
      tool.file('no.glb'),
      ...more,
    )

  it('a folder without a neutral map', async () => {
    writeAll('no-neutral', { 'angry.png': await normalPng(source.neutral) })
    await refuses('no neutral normal map in', 'no-neutral')
  })

  it('a folder without expressions', async () => {
    writeAll('alone', { 'neutral.png': await normalPng(source.neutral) })
    await refuses('no normal map of an expression in', 'alone')
  })

  it('maps that are equal', async () => {
    const png = await normalPng(source.neutral)
    writeAll('equal', { 'neutral.png': png, 'angry.png': png })
    await refuses('no expression differs from the neutral map', 'equal')
  })

  it('a truncated image', async () => {
    const png = await normalPng(source.neutral)
    writeAll('cut', { 'neutral.png': png, 'angry.png': png.subarray(0, png.length / 2) })
    await refuses('angry.png', 'cut')
  })

  it.each([
    [{ expressions: [{ name: 'a', normal: 'neutral.png' }] }, 'neutral must be an object'],
    [
      { neutral: { normal: '../x.png' }, expressions: [{ name: 'a', normal: 'a.png' }] },
      'names a missing image',
    ],
    [{ neutral: { normal: 'neutral.png' }, expressions: [] }, 'wrong number of items'],
  ])('the document %j', async (document, message) => {
    writeAll('bad', { 'neutral.png': await normalPng(source.neutral) })
    tool.shop.json('bad/expressions.json', document)
    await refuses(message, 'bad')
  })

  it('FBX, and names the remedy', async () => {
    tool.shop.write('face.fbx', 'Kaydara FBX Binary  \0')
    await refuses(/FBX, which the command does not read.*--face; Blender converts FBX to glTF$/, 'face.fbx')
  })
})
