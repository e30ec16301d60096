import type { Skin } from 'furrow/author'
import { canonicalTargetName } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { labelOf } from '../../../../packages/furrow/src/author/shapes/families.ts'
import { SURE } from '../../../../packages/furrow/src/author/shapes/matching/confidence.ts'
import { recogniseShapes } from '../../../../packages/furrow/src/author/shapes/recognise.ts'
import { TEMPLATES } from '../../../../packages/furrow/src/author/shapes/templates/template-data.ts'
import { templateHeads } from '../../../../packages/furrow/src/author/shapes/templates/template-table.ts'
import { TEMPLATE_FACES, templateText } from '../../../../scripts/lib/shape-templates.ts'
import { SCANS } from '../../../bare-faces/bare-faces.ts'
import { seeded } from '../../../random.ts'
import { skinAt } from '../../../skin-at.ts'
import { unlabelledShapes } from '../../../unlabelled-shapes.ts'

/** Matches the shapes of ARKit that wrinkles depend on. */
const MATTER =
  /^(brow(Down|OuterUp|InnerUp)|eye(Blink|Squint)|cheek(Squint|Puff)|noseSneer|mouth(Smile|Frown|Pucker)|jawOpen)/

const [builder, scan] = templateHeads()
let human: Skin

beforeAll(async () => {
  human = await skinAt(TEMPLATE_FACES.builder[1])
})

/** Keeps the ARKit shapes that move the skin, and replaces their names by numbers. `truth` has their names in ARKit. */
function nameless(skin: Skin): { skin: Skin; truth: string[] } {
  const moving = skin.targets.filter(
    ({ name, offsets }) =>
      labelOf(canonicalTargetName(name)) && Array.from(offsets).some((x) => Math.abs(x) > 1e-5),
  )
  return {
    skin: { ...skin, targets: moving.map(({ offsets }, i) => ({ name: `${i}`, offsets })) },
    truth: moving.map(({ name }) => canonicalTargetName(name)),
  }
}

/** Returns a skin with a function applied to its positions and to the offsets of its blendshapes. */
function transformed(skin: Skin, map: (x: number, y: number, z: number) => number[]): Skin {
  const all = (values: ArrayLike<number>) => {
    const out = new Float32Array(values.length)
    for (let i = 0; i < out.length; i += 3) out.set(map(values[i]!, values[i + 1]!, values[i + 2]!), i)
    return out
  }
  const targets = skin.targets.map((target) => ({ ...target, offsets: all(target.offsets) }))
  return { ...skin, positions: all(skin.positions), targets }
}

const swapped = (name: string) => name.replace(/Left|Right/, (side) => (side === 'Left' ? 'Right' : 'Left'))

/** Makes a blendshape. `offset` returns the offset of a vertex. */
function target(name: string, offset: (i: number) => number[]) {
  const offsets = new Float32Array(human.positions.length)
  for (let i = 0; i < offsets.length / 3; i++) offsets.set(offset(i), 3 * i)
  return { name, offsets }
}

const at = (values: ArrayLike<number>, i: number) => [0, 1, 2].map((k) => values[3 * i + k]!)

describe('shapes without names', () => {
  const heads = [
    ['a shipped face, from the scan', () => human, scan],
    ...SCANS.map(({ path }) => ['the scan, from the shipped faces', () => skinAt(path), builder] as const),
  ] as const

  test.each(heads)('are recognised on %s', async (_, read, templates) => {
    const { skin, truth } = nameless(await read())
    const found = recogniseShapes(skin, [templates!]).shapes
    const right = found.filter(({ shape }, i) => shape === truth[i])
    expect(right.length).toBeGreaterThanOrEqual(0.93 * truth.length)
    const matter = truth.flatMap((name, i) => (MATTER.test(name) ? [i] : []))
    expect(matter.filter((i) => found[i]!.shape !== truth[i])).toEqual([])
    expect(found.filter(({ shape }, i) => shape !== undefined && shape !== truth[i])).toEqual([])
  })

  test.each([
    [
      'rotated and in centimetres',
      (x: number, y: number, z: number) => [-100 * z, 100 * x, -100 * y],
      (name: string) => name,
    ],
    ['mirrored', (x: number, y: number, z: number) => [-x, y, z], swapped],
  ])('are recognised on a face that is %s', (_, map, rename) => {
    const { skin, truth } = nameless(human)
    const found = recogniseShapes(transformed(skin, map)).shapes.map(({ shape }) => shape)
    expect(found).toEqual(truth.map(rename))
  })

  test('have no wrong match if a face has only ten or twenty', () => {
    const { skin, truth } = nameless(human)
    let known = 0
    for (const count of [10, 20]) {
      const random = seeded(5)
      for (let n = 0; n < 4; n++) {
        const order = [...truth.keys()].map((i) => [random(), i] as const).sort(([a], [b]) => a - b)
        const some = order.slice(0, count).map(([, i]) => i)
        const targets = some.map((i) => skin.targets[i]!)
        for (const [k, { shape, confidence }] of recogniseShapes({ ...skin, targets }, [
          scan!,
        ]).shapes.entries()) {
          if (confidence <= SURE) continue
          expect(shape).toBe(truth[some[k]!])
          known++
        }
      }
    }
    expect(known).toBeGreaterThan(8)
  })

  test('have no wrong match if a face has only shapes of speech', () => {
    const { skin, truth } = nameless(human)
    const speech = truth.flatMap((name, i) =>
      /^(jawOpen|mouth(Pucker|Funnel|Close|Stretch))/.test(name) ? [i] : [],
    )
    const found = recogniseShapes({ ...skin, targets: speech.map((i) => skin.targets[i]!) }).shapes
    // A shape may stay unknown: without a shape that closes the lids, the positions of the eyes are a guess.
    for (const [k, { shape }] of found.entries()) expect([undefined, truth[speech[k]!]]).toContain(shape)
  })
})

test('names are used if the motion agrees', () => {
  for (const { name, shape, isMisnamed } of recogniseShapes(human).shapes) {
    expect([shape, isMisnamed]).toEqual([name, false])
  }
})

test('motion overrides names with the wrong side or of another shape', () => {
  const wrong: Record<string, string> = { jawOpen: 'browInnerUp', browInnerUp: 'jawOpen' }
  const targets = human.targets.map(({ name, offsets }) => ({ name: wrong[name] ?? swapped(name), offsets }))
  const found = recogniseShapes({ ...human, targets }).shapes
  for (const [i, { name }] of human.targets.entries()) {
    // Skips other shapes, such as sideways motion of the mouth, and the tongue, which is another mesh.
    if (!/^(eye|brow|cheek|nose|mouth(Smile|Frown)|jawOpen)/.test(name)) continue
    expect([name, found[i]!.shape]).toEqual([name, name])
  }
})

test('shapes that change proportions, move hidden parts, turn the head or correct other shapes are unknown', () => {
  const { skin } = nameless(human)
  const { positions } = human
  const eyes =
    Math.max(...Array.from({ length: positions.length / 3 }, (_, i) => positions[3 * i + 1]!)) - 0.11
  const others = [
    target('wide', (i) => [0.15 * at(positions, i)[0]!, 0, 0]),
    target('tall', (i) => [0, 0.2 * Math.max(0, at(positions, i)[1]! - eyes), 0]),
    target('hidden', (i) => at(positions, i).map((x) => -0.93 * x)),
    target('nod', (i) => [0, -0.2 * at(positions, i)[2]!, 0.2 * (at(positions, i)[1]! - eyes)]),
    target('fat', (i) => [0.1 * at(positions, i)[0]!, 0, 0.1 * at(positions, i)[2]!]),
  ]
  const found = recogniseShapes({ ...skin, targets: [...skin.targets, ...others] }).shapes.slice(
    -others.length,
  )
  expect(found.map(({ shape }) => shape)).toEqual(others.map(() => undefined))
})

test('confident matches are right on a face that also has shapes for proportions and expressions', () => {
  const { skin, truth } = nameless(human)
  const others = unlabelledShapes(human)
  const found = recogniseShapes({ ...skin, targets: [...skin.targets, ...others] }, [scan!]).shapes
  const sure = [...found.entries()].filter(([, { confidence }]) => confidence > SURE)
  expect(sure.map(([, { shape }]) => shape)).toEqual(sure.map(([i]) => truth[i]))
  expect(sure.length).toBeGreaterThan(0.8 * truth.length)
})

test('a mesh without a face has no shapes', () => {
  const hidden = target('hidden', (i) => at(human.positions, i).map((x) => -0.9 * x))
  expect(recogniseShapes({ ...human, targets: [hidden] }).shapes.map(({ by }) => by)).toEqual(['name'])
  const broken = {
    ...human,
    positions: human.positions.length ? new Float32Array(human.positions.length).fill(Number.NaN) : [],
  }
  expect(recogniseShapes(broken).shapes.every(({ by }) => by === 'name')).toBe(true)
})

test('the committed table of templates equals the one computed from its faces', async () => {
  expect(await templateText(TEMPLATE_FACES.builder)).toBe(TEMPLATES.builder)
  for (const { path } of SCANS) expect(await templateText([path])).toBe(TEMPLATES.scan)
})
