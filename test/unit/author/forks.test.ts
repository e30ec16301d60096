import { insertPoint, removePoint, type Stroke, skinCanvas, smoothStroke } from 'furrow/author'
import {
  detachStroke,
  findForks,
  moveFork,
  pullBranches,
  StrokeLines,
  withForkPoints,
  withPoint,
} from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { STROKE_DEFAULTS } from '../../../packages/furrow/src/author/strokes/document.ts'
import { cylinder, placeOf, RADIUS, strokeOn, uvOf } from './skins.ts'

const skin = skinCanvas(cylinder(), 64)
const lines = new StrokeLines(skin)
/** Length of half a turn, millimetres. */
const HALF_TURN = Math.PI * RADIUS

/** Returns a stroke through points of the cylinder, which fades only at its start. */
const stroke = (points: Parameters<typeof strokeOn>[0], more: Partial<Stroke> = {}) =>
  strokeOn(points, { taper: [0.2, 0], ...more })

/** Horizontal stroke at half the height, that crosses the seam at turn 1. Its points are 0.2 turns apart. */
const trunk = stroke([0.5, 0.7, 0.9, 1.1, 1.3, 1.5].map((turn) => [turn, 30]))
/** Ends on the trunk, between two of its points. */
const branch = stroke([
  [0.7, 45],
  [0.75, 38],
  [0.8, 30],
])
/** Ends on the trunk at the same place, from the other side. */
const other = stroke([
  [0.8, 30.1],
  [0.9, 15],
])
/** Ends on the branch. */
const twig = stroke([
  [0.6, 36],
  [0.775, 34],
])

const endOf = ({ points }: Stroke, end: 0 | 1) => placeOf(points.at(-end)!)
/** Distance between two places on the cylinder, millimetres. */
const apart = (a: readonly number[], b: readonly number[]) =>
  Math.hypot((a[0] - b[0]) * HALF_TURN, a[1] - b[1])
const all = (strokes: readonly Stroke[], changed: ReadonlyMap<number, Stroke>) =>
  strokes.map((each, i) => changed.get(i) ?? each)
const forked = (strokes: readonly Stroke[]) => ({ strokes, forks: findForks(strokes, lines), lines })
/** Returns indices and ends of the strokes of each fork. */
const membersOf = (strokes: readonly Stroke[]) =>
  findForks(strokes, lines).map(({ ends, trunks }) => [
    ends.map((each) => `${each.stroke} ${each.end}`).sort(),
    trunks.map((each) => each.stroke),
  ])

describe('forks', () => {
  it('are found where ends touch another stroke, and not where strokes cross, or of bulges and valleys', () => {
    expect(membersOf([trunk, branch, other, twig])).toEqual([
      [['1 1', '2 0'], [0]],
      [['3 1'], [1]],
    ])
    const crossing = stroke([
      [0.8, 15],
      [0.82, 45],
    ])
    expect(membersOf([trunk, crossing])).toEqual([])
    expect(membersOf([trunk, { ...branch, layer: 'other' }])).toEqual([])
    expect(membersOf([trunk, { ...branch, depth: -1 }])).toEqual([])
  })

  it('are found at UV seams, and where two ends meet', () => {
    const seam = stroke([
      [1, 50],
      [1, 30],
    ])
    expect(membersOf([trunk, seam])).toEqual([[['1 1'], [0]]])
    const next = stroke([
      [1.5, 30],
      [1.6, 40],
    ])
    expect(membersOf([trunk, next])).toEqual([[['0 1', '1 0'], []]])
  })

  it.each([
    [0.3, 1],
    [0.8, 0],
  ])('reach %d mm', (gap, count) => {
    const near = stroke([
      [0.7, 45],
      [0.8, 30 + gap],
    ])
    expect(findForks([trunk, near], lines).length).toBe(count)
  })
})

describe('a fork that is moved', () => {
  const strokes = withForkPoints(
    [trunk, branch, other, twig],
    findForks([trunk, branch, other, twig], lines)[0],
    lines,
  )
  const [fork] = findForks(strokes, lines)
  const target = uvOf(0.85, 34)
  const moved = all(strokes, moveFork(forked(strokes), fork, target))

  it('takes along its trunk and the ends of all branches, and nothing else of these', () => {
    expect(strokes[0].points.length).toBe(trunk.points.length + 1)
    for (const [index, end] of [
      [1, 1],
      [2, 0],
    ] as const)
      expect(apart(endOf(moved[index], end), [0.85, 34])).toBeLessThan(0.01)
    expect(moved[0].points.toSpliced(2, 1)).toEqual(trunk.points)
    expect(moved[0].points[2]).toEqual(target)
    expect(moved[1].points.slice(0, 2)).toEqual(branch.points.slice(0, 2))
    expect(membersOf(moved)).toEqual(membersOf(strokes))
  })

  it('gets no second point in the trunk', () => {
    expect(withForkPoints(strokes, fork, lines)).toBe(strokes)
  })
})

describe('a changed trunk', () => {
  const strokes = [trunk, branch, other, twig]
  const changedTo = (own: Stroke, removed?: number) =>
    all(strokes, pullBranches(forked(strokes), new Map([[0, own]]), removed))

  it('keeps its branches, and the branches of these', () => {
    const moved = changedTo(withPoint(trunk, 1, uvOf(0.7, 33), lines))
    expect(membersOf(moved)).toEqual(membersOf(strokes))
    expect(endOf(moved[1], 1)[1]).toBeGreaterThan(31)
    expect(apart(endOf(moved[1], 1), endOf(moved[2], 0))).toBeLessThan(0.2)
  })

  it('returns with its branches to the same place', () => {
    const there = changedTo(withPoint(trunk, 1, uvOf(0.7, 33), lines))
    const back = all(there, pullBranches(forked(there), new Map([[0, trunk]])))
    expect(apart(endOf(back[1], 1), endOf(branch, 1))).toBeLessThan(0.5)
  })

  it('keeps its branches when it is smoothed or loses a point', () => {
    const bent = withPoint(trunk, 2, uvOf(0.9, 36), lines)
    const before = changedTo(bent)
    const smooth = all(before, pullBranches(forked(before), new Map([[0, smoothStroke(bent, 1, skin)]])))
    expect(membersOf(smooth)).toEqual(membersOf(strokes))
    expect(endOf(smooth[1], 1)[1]).toBeLessThan(endOf(before[1], 1)[1] - 1)
    const shorter = all(before, pullBranches(forked(before), new Map([[0, removePoint(bent, 2, skin)]]), 2))
    expect(membersOf(shorter)).toEqual(membersOf(strokes))
  })

  it('leaves a branch behind that it no longer reaches', () => {
    const near = [trunk, stroke([[0.6, 45], [0.6, 30]])] // biome-ignore format: one line
    const cut = pullBranches(forked(near), new Map([[0, removePoint(trunk, 0, skin)]]), 0)
    expect([...cut.keys()]).toEqual([0])
  })
})

describe('a detached branch', () => {
  const detached = (own: Stroke) => detachStroke([trunk, own], 1, findForks([trunk, own], lines), lines)

  it('ends 2 mm before the trunk, fades there, and keeps its depths and its line', () => {
    const own = { ...branch, depths: [1, 0.8, 0.6, 0.4] }
    const after = detached(own)
    expect(membersOf([trunk, after])).toEqual([])
    expect(apart(endOf(after, 1), endOf(branch, 1))).toBeCloseTo(2, 0)
    expect(after.points[0]).toEqual(branch.points[0])
    expect(after.taper).toEqual([expect.closeTo(0.23, 1), 0.2])
    expect(after.depths!.at(-1)).toBeCloseTo(0.44, 1)
  })

  it('is shortened until it leaves a trunk that it runs along', () => {
    const beside = stroke([
      [0.4, 45],
      [0.7, 30.2],
      [0.8, 30],
    ])
    const after = detached(beside)
    expect(findForks([trunk, after], lines)).toEqual([])
    expect(endOf(after, 1)[1]).toBeCloseTo(32, 0)
  })

  it('loses at most half of its length, also at its start', () => {
    const short = stroke([
      [0.8, 30],
      [0.8, 33],
    ])
    const after = detached(short)
    expect(endOf(after, 0)[1]).toBeCloseTo(31.5, 0)
    expect(after.taper[0]).toBe(STROKE_DEFAULTS.taper[0])
  })
})

it('a point that is added to a trunk keeps its branches', () => {
  const { stroke: longer } = insertPoint(trunk, 0.2, skin)
  expect(membersOf([longer, branch, other])).toEqual([[['1 1', '2 0'], [0]]])
})
