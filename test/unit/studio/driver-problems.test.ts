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

describe('driverProblems', () => {
  it('finds nothing in a valid driver', () => {
    expect(problemsOf([morph(['browInnerUp', 'browOuterUpLeft'])])).toEqual([])
  })

  it('finds nothing in the drivers of other areas', () => {
    expect(problemsOf([morph(['noseSneerLeft'])], 'nose')).toEqual([])
  })

  it('finds a blendshape that the face lacks, with a remedy', () => {
    const [[index, { text, remedy }]] = problemsOf([morph(['browInnerUp']), morph(['noseSneerLeft'])])
    expect(index).toBe(1)
    expect(text).toContain('no blendshape noseSneerLeft')
    expect(remedy).not.toBe('')
  })

  it('finds an area that drives itself, and suggests removing the driver', () => {
    const circle = [
      { type: 'area', area: 'brow', areas: [{ name: 'nose' }] },
      { type: 'area', area: 'nose', areas: [{ name: 'brow' }] },
    ]
    const [[index, problem]] = problemsOf(circle)
    expect(problem.text).toContain('drives itself')
    expect(problem.removes).toBe(index)
  })

  it('finds a delay that a later one replaces', () => {
    const delay = { type: 'time', area: 'brow', attack: 0.1 }
    const problems = problemsOf([delay, delay])
    expect(problems.map(([index, { removes }]) => [index, removes])).toEqual([[0, 0]])
  })

  it('finds a type of driver of a later version', () => {
    expect(problemsOf([{ type: 'breath', area: 'brow' }])[0][1].text).toContain('breath')
  })

  it.each([
    ['min', 'never shows'],
    ['product', 'never shows'],
    ['sum', 'less'],
  ])('finds two blendshapes that cancel each other, with the rule %s', (rule, text) => {
    const [[index, problem]] = problemsOf([conflict, morph(['browDownLeft', 'browInnerUp'], rule)])
    expect(index).toBe(1)
    expect(problem.text).toContain(text)
    expect(problem.removes).toBe(0)
  })

  it('finds nothing if the rule takes the larger of the two', () => {
    expect(problemsOf([conflict, morph(['browDownLeft', 'browInnerUp'], 'max')])).toEqual([])
  })
})

it("an area lists the conflicts of its drivers' blendshapes, in any spelling, and conflicts that concern no area", () => {
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
