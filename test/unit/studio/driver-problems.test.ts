import { parseDrivers } from 'furrow'
import { describe, expect, it } from 'vitest'
import { conflictsOf, driverProblems } from '../../../studio/src/document/driver-problems.ts'

const AREAS = ['brow', 'nose']
const SHAPES = ['browInnerUp', 'browDownLeft', 'BrowOuterUp_L']
const conflict = { type: 'conflict', targets: ['browInnerUp', 'browDownLeft'] }

function problemsOf(drivers: readonly object[], area = 'brow') {
  return [...driverProblems(parseDrivers(drivers, AREAS), area, SHAPES)]
}

const morph = (names: string[], rule = 'sum') => ({
  type: 'morph',
  area: 'brow',
  rule,
  targets: names.map((name) => ({ name })),
})

describe('an invalid driver is reported with a remedy:', () => {
  it('not a valid one', () => {
    expect(problemsOf([morph(['browInnerUp', 'browOuterUpLeft'])])).toEqual([])
  })

  it('not one of another area', () => {
    expect(problemsOf([morph(['noseSneerLeft'])], 'nose')).toEqual([])
  })

  it('a blendshape that the face lacks', () => {
    const [[index, { text, remedy }]] = problemsOf([morph(['browInnerUp']), morph(['noseSneerLeft'])])
    expect(index).toBe(1)
    expect(text).toContain('no blendshape noseSneerLeft')
    expect(remedy).not.toBe('')
  })

  it('an area that drives itself', () => {
    const circle = [
      { type: 'area', area: 'brow', areas: [{ name: 'nose' }] },
      { type: 'area', area: 'nose', areas: [{ name: 'brow' }] },
    ]
    const [[index, problem]] = problemsOf(circle)
    expect(problem.text).toContain('drives itself')
    expect(problem.removes).toBe(index)
  })

  it('a delay that a later one replaces', () => {
    const delay = { type: 'time', area: 'brow', attack: 0.1 }
    const problems = problemsOf([delay, delay])
    expect(problems.map(([index, { removes }]) => [index, removes])).toEqual([[0, 0]])
  })

  it('a type of a later version', () => {
    expect(problemsOf([{ type: 'breath', area: 'brow' }])[0][1].text).toContain('breath')
  })

  it.each([
    ['min', 'never shows'],
    ['product', 'never shows'],
    ['sum', 'less'],
  ])('two blendshapes that cancel each other, by the rule %s', (rule, text) => {
    const [[index, problem]] = problemsOf([conflict, morph(['browDownLeft', 'browInnerUp'], rule)])
    expect(index).toBe(1)
    expect(problem.text).toContain(text)
    expect(problem.removes).toBe(0)
  })

  it('but not if the larger of the two counts', () => {
    expect(problemsOf([conflict, morph(['browDownLeft', 'browInnerUp'], 'max')])).toEqual([])
  })
})

it("an area lists the conflicts of its drivers' blendshapes in any spelling, and those that concern no area", () => {
  const drivers = parseDrivers(
    [
      morph(['browInnerUp_L', 'browInnerUp']),
      { type: 'morph', area: 'nose', targets: [{ name: 'jawOpen' }] },
      conflict,
      { type: 'conflict', targets: ['jawOpen', 'mouthClose'] },
      { type: 'conflict', targets: ['eyeWideLeft', 'eyeBlinkLeft'] },
    ],
    AREAS,
  )
  expect(conflictsOf(drivers, 'brow')).toEqual([2, 4])
  expect(conflictsOf(drivers, 'nose')).toEqual([3, 4])
})
