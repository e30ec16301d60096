import { insertPoint, parseStrokes, removePoint, type Stroke, skinCanvas, splitStroke } from 'furrow/author'
import { middleOf, mirrorStroke, nearestOnStroke, splineOf, strokeCurves } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { layOutStroke } from '../../../packages/furrow/src/author/strokes/lay-out.ts'
import { cylinder, RADIUS, uvOf } from './skins.ts'

const canvas = skinCanvas(cylinder(), 64)

/** Stroke that rises on the front of the cylinder, crosses its UV seam at +x, and falls on the back. */
const wave: Stroke = {
  group: 'cheekLeft',
  curve: 'spline',
  points: [
    [0.3, 20],
    [0.6, 26],
    [0.9, 34],
    [1.2, 28],
    [1.5, 24],
  ].map(([turn, y]) => uvOf(turn, y)),
  width: 2,
  depth: 1,
  depths: [0.5, 1, 0.25],
  taper: [0.2, 0.4],
  shoulder: [1, 0.2],
  softness: 0.4,
  waviness: 0,
}

/** Returns the largest distance from a point of a stroke to the nearest of other strokes, millimetres. */
function farthest(stroke: Stroke, others: readonly Stroke[]): number {
  const curves = others.flatMap((other) => strokeCurves(other, canvas))
  return Math.max(
    ...strokeCurves(stroke, canvas).flatMap(({ points, along }) =>
      Array.from(along, (_, i) => {
        const [x, y, z] = points.subarray(3 * i, 3 * i + 3)
        return 1000 * (nearestOnStroke(curves, [x, y, z])?.distance ?? Infinity)
      }),
    ),
  )
}

/** Expects that the parser of strokes documents accepts the strokes and does not change them. */
function expectValid(...strokes: Stroke[]): void {
  expect(parseStrokes({ version: 1, strokes: JSON.parse(JSON.stringify(strokes)) }).strokes).toEqual(strokes)
}

describe('a stroke as a line in space', () => {
  it('lies on the skin in mesh coordinates, from start to end', () => {
    const [{ points, normals, along }, ...others] = strokeCurves(wave, canvas)
    expect(others).toEqual([])
    expect([along[0], along.at(-1)]).toEqual([0, 1])
    for (let i = 0; i < points.length; i += 3) {
      expect(Math.hypot(points[i], points[i + 2])).toBeCloseTo(RADIUS / 1000, 4)
      expect(Math.hypot(...normals.subarray(i, i + 3))).toBeCloseTo(1)
      if (i > 0) expect(along[i / 3]).toBeGreaterThan(along[i / 3 - 1])
    }
  })

  it('measures length continuously across seams', () => {
    const points = [0.2, 0.8].map((u): [number, number] => [u, 0.5])
    const curves = strokeCurves({ ...wave, curve: 'polyline', points }, canvas)
    expect(curves.length).toBe(2)
    expect(curves[1].along[0]).toBe(curves[0].along.at(-1))
    expect(curves[1].along.at(-1)).toBe(1)
  })

  it('has a nearest point to any position', () => {
    const [{ points, along }] = strokeCurves(wave, canvas)
    const i = Math.floor(along.length / 3)
    const [x, y, z] = points.subarray(3 * i, 3 * i + 3)
    const found = nearestOnStroke(strokeCurves(wave, canvas), [x * 1.1, y, z * 1.1])
    expect(found?.along).toBeCloseTo(along[i], 2)
    expect(found?.distance).toBeCloseTo(0.1 * (RADIUS / 1000), 4)
    expect(nearestOnStroke([], [0, 0, 0])).toBeUndefined()
  })
})

describe('points of a stroke', () => {
  it.each([0.1, 0.4, 0.6, 0.95])('are inserted at %d of the line without moving it', (along) => {
    const { stroke, index } = insertPoint(wave, along, canvas)
    expect(stroke.points.length).toBe(6)
    expect(stroke.points.toSpliced(index, 1)).toEqual(wave.points)
    // The tolerance is about 1% of the distance between points, which is 17 mm.
    expect(farthest(stroke, [wave])).toBeLessThan(0.25)
    expect(farthest(wave, [stroke])).toBeLessThan(0.25)
    expect(removePoint(stroke, index, canvas)).toEqual(wave)
    expectValid(stroke)
  })

  it('are not inserted at existing points, or where the stroke is off the skin', () => {
    expect(insertPoint(wave, 0, canvas)).toEqual({ stroke: wave, index: -1 })
    const beside: Stroke = { ...wave, points: [[0.01, 0.01], [0.02, 0.02]] } // biome-ignore format: one line
    expect(insertPoint(beside, 0.5, canvas)).toEqual({ stroke: beside, index: -1 })
  })

  it('can be removed until two are left', () => {
    const short = { ...wave, points: wave.points.slice(0, 2) }
    expect(() => removePoint(short, 0, canvas)).toThrow('removePoint: a stroke needs two points')
    expect(() => removePoint(wave, 5, canvas)).toThrow('removePoint: point index out of range')
  })
})

describe('splineOf', () => {
  it.each(['polyline', 'bezier'] as const)('converts a %s in place', (curve) => {
    const points: [number, number][] = [[0.1, 0.3], [0.2, 0.7], [0.3, 0.2], [0.4, 0.6]] // biome-ignore format: one line
    const spline = splineOf({ ...wave, curve, points }, canvas)
    expect(spline.curve).toBe('spline')
    expect(farthest({ ...wave, curve, points }, [spline])).toBeLessThan(0.2)
    expectValid(spline)
  })
})

describe('a split stroke', () => {
  const at = (stroke: Stroke, along: number) => {
    const [{ depths }] = layOutStroke(stroke, canvas)
    return depths[Math.round(along * (depths.length - 1))]
  }

  it.each([1, 2, 3])('has two parts with the same course and depth, if split at point %d', (index) => {
    const parts = splitStroke(wave, index, canvas)
    expectValid(...parts)
    for (const part of parts) expect(farthest(part, [wave])).toBeLessThan(0.1)
    expect(farthest(wave, parts)).toBeLessThan(0.1)
    expect(parts.map(({ taper }) => [taper[0] === 0, taper[1] === 0])).toEqual([
      [false, true],
      [true, false],
    ])
    const [first, second] = parts.map((part) => layOutStroke(part, canvas)[0].depths.length)
    const cut = first / (first + second)
    for (const t of [0.05, 0.3, 0.6, 0.95]) {
      expect(at(parts[0], t)).toBeCloseTo(at(wave, t * cut), 1)
      expect(at(parts[1], t)).toBeCloseTo(at(wave, cut + t * (1 - cut)), 1)
    }
  })

  it('keeps a constant depth without factors', () => {
    const { depths: _, ...even } = wave
    for (const part of splitStroke<Stroke>({ ...even, taper: [0.1, 0.1] }, 2, canvas))
      expect(part.depths).toBeUndefined()
  })

  it('cannot be split at its ends', () => {
    for (const index of [0, 4, 1.5])
      expect(() => splitStroke(wave, index, canvas)).toThrow(/splitStroke: point index out of range/)
  })
})

describe('a mirrored stroke', () => {
  it('lies on the other side, with mirrored banks and group', () => {
    const mirrored = mirrorStroke(wave, canvas)
    expect(mirrored).toMatchObject({ shoulder: [0.2, 1], group: 'cheekRight' })
    const [[own], [other]] = [strokeCurves(wave, canvas), strokeCurves(mirrored, canvas)]
    for (let i = 0; i < own.points.length; i += 30) {
      const [x, y, z] = own.points.subarray(i, i + 3)
      expect(1000 * (nearestOnStroke([other], [-x, y, z])?.distance ?? 1)).toBeLessThan(0.1)
    }
    expect(farthest(mirrorStroke(mirrored, canvas), [wave])).toBeLessThan(0.1)
    expectValid(mirrored)
  })

  it('can be mirrored at any plane', () => {
    const mirrored = mirrorStroke(wave, canvas, { origin: [0, 0, 0], normal: [0, 0, 1] })
    const [{ points }] = strokeCurves(mirrored, canvas)
    const [start] = strokeCurves(wave, canvas)
    expect(points[0]).toBeCloseTo(start.points[0], 4)
    expect(points[2]).toBeCloseTo(-start.points[2], 4)
  })

  it('can be mirrored at the middle only on a face', () => {
    const { positions, uvs, indices = [] } = cylinder()
    expect(middleOf({ positions, uvs, indices, targets: [] })).toBeUndefined()
  })
})
