import { EXPRESSIONS, type Expression, findTargets } from 'furrow'
import { faceExpressions } from 'furrow/internal'
import { expect, it } from 'vitest'

const expression = (
  name: string,
  targets: Record<string, number> = {},
  activations: Record<string, number> = {},
): Expression => ({ name, targets, activations })

const named = (parts: {
  shapes: string[]
  authored?: Expression[]
  vrm?: Expression[]
  areas?: string[]
}): string[] =>
  faceExpressions({
    authored: parts.authored ?? [],
    vrm: parts.vrm ?? [],
    targetsAmong: (names) => new Set(names.filter((name) => findTargets(name, parts.shapes).length > 0)),
    hasArea: (area) => parts.areas?.includes(area) ?? false,
  }).map(({ name }) => name)

const ARKIT = [...new Set(EXPRESSIONS.flatMap(({ targets }) => Object.keys(targets)))]

it.each<[string, Parameters<typeof named>[0], string[]]>([
  ['all presets for ARKit', { shapes: ARKIT }, EXPRESSIONS.map(({ name }) => name)],
  ['neutral alone for visemes', { shapes: ['viseme_aa', 'jawOpen'] }, ['neutral']],
  ["VRoid's shapes", { shapes: ['Fcl_ALL_Angry', 'Fcl_ALL_Joy'] }, ['neutral', 'happy', 'angry']],
  ['a shape called angry', { shapes: ['angry'] }, ['neutral', 'angry']],
  ['presets by what they move most', { shapes: ['mouthPress_L', 'noseSneer_L'] }, ['neutral', 'disgusted']],
  [
    "a VRM's and presets",
    {
      shapes: ['m_01', 'browDownLeft', 'browDownRight'],
      vrm: [expression('happy', { m_01: 0.5 }), expression('dizzy', { m_01: 1 })],
    },
    ['neutral', 'happy', 'dizzy', 'angry'],
  ],
  [
    "a VRM's neutral first",
    {
      shapes: ['m_01'],
      vrm: [expression('happy', { m_01: 1 }), expression('neutral', { m_01: 0.1 })],
    },
    ['neutral', 'happy'],
  ],
  [
    "the author's in place of presets, without those that do nothing",
    {
      shapes: ARKIT,
      areas: ['scar'],
      authored: [expression('rest'), expression('happy'), expression('shown', {}, { scar: 1 })],
      vrm: [expression('happy', { jawOpen: 1 })],
    },
    ['rest', 'shown', 'happy'],
  ],
])('a face offers %s', (_, face, expected) => {
  expect(named(face)).toEqual(expected)
})
