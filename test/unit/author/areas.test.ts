import { paintAreas, parseStrokes } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { flatCanvas } from './planes.ts'

const line = (v: number, group?: string) => ({
  points: [
    [0.2, v],
    [0.8, v],
  ],
  width: 2,
  depth: 0.5,
  ...(group && { group }),
})

// 128 mm in 128 texels: the centre of texel i lies at i + 0.5 mm.
const canvas = flatCanvas(128, 128, 128)
const square = [
  [0.25, 0.25],
  [0.75, 0.25],
  [0.75, 0.75],
  [0.25, 0.75],
]

function paint(areas: object[], strokes = [line(0.5, 'brow')]) {
  return paintAreas(parseStrokes({ version: 1, strokes, areas }), canvas)
}

describe('paintAreas', () => {
  it('is 255 inside a polygon, 0 outside its feather, and half on the outline', () => {
    const [{ name, weights }] = paint([{ name: 'patch', shapes: [{ polygon: square, feather: 8 }] }]) as [
      ReturnType<typeof paint>[0],
    ]
    expect(name).toBe('patch')
    for (let y = 0; y < 128; y++) {
      for (let x = 0; x < 128; x++) {
        const [px, py] = [x + 0.5, y + 0.5]
        const inside = Math.min(px - 32, 96 - px, py - 32, 96 - py)
        const weight = weights.data[y * 128 + x]
        if (inside >= 4) expect(weight).toBe(255)
        if (inside <= -4) expect(weight).toBe(0)
        if (inside > 0 && inside < 4) expect(weight).toBeGreaterThan(127)
      }
    }
    // Half a millimetre inside: smoothstep(0.5 + 0.5 / 8).
    const t = 0.5 + 0.5 / 8
    expect(weights.data[64 * 128 + 32]).toBe(Math.round(255 * t * t * (3 - 2 * t)))
  })

  it('surrounds the strokes of a group by its radius', () => {
    const [area] = paint(
      [{ name: 'brow', shapes: [{ group: 'brow', radius: 6, feather: 4 }] }],
      [line(0.5, 'brow'), line(0.1, 'other')],
    )
    const column = Array.from({ length: 128 }, (_, y) => area.weights.data[y * 128 + 64])
    for (let y = 0; y < 128; y++) {
      const distance = Math.abs(y + 0.5 - 64)
      if (distance <= 4) expect(column[y]).toBe(255)
      if (distance >= 8) expect(column[y]).toBe(0)
    }
    expect(column[64 + 5]).toBeGreaterThan(127)
    expect(column[64 + 6]).toBeLessThan(127)
  })

  it('takes the larger of overlapping shapes', () => {
    const shape = { polygon: square, feather: 8 }
    const [once] = paint([{ name: 'a', shapes: [shape] }])
    const [twice] = paint([{ name: 'a', shapes: [shape, shape] }])
    expect(twice.weights.data).toEqual(once.weights.data)
  })

  it('splits into halves that sum to the whole, each zero beyond the blend', () => {
    const half = (from: number, to: number) => ({
      polygon: [
        [from, 0],
        [to, 0],
        [to, 1],
        [from, 1],
      ],
      feather: 10,
    })
    const shapes = [{ polygon: square, feather: 6 }]
    const [left, right, whole] = paint([
      { name: 'left', shapes, within: half(0.5, 1) },
      { name: 'right', shapes, within: half(0, 0.5) },
      { name: 'whole', shapes },
    ])
    for (let i = 0; i < 128 * 128; i++) {
      const x = (i % 128) + 0.5
      // At the border of the map the outline of a half is softened too.
      if (x < 10 || x > 118) continue
      const sum = left.weights.data[i] + right.weights.data[i]
      expect(Math.abs(sum - whole.weights.data[i])).toBeLessThanOrEqual(1)
      if (x < 64 - 5) expect(left.weights.data[i]).toBe(0)
      if (x > 64 + 5) expect(right.weights.data[i]).toBe(0)
    }
    expect(left.weights.data[64 * 128 + 70]).toBe(255)
  })

  it('makes one area per group where the document describes none', () => {
    const document = parseStrokes({
      version: 1,
      strokes: [line(0.3, 'upper'), line(0.7, 'lower'), line(0.5), line(0.32, 'upper')],
    })
    const areas = paintAreas(document, canvas)
    expect(areas.map((area) => area.name)).toEqual(['upper', 'lower'])
    expect(areas[0].weights.data[Math.floor(0.3 * 128) * 128 + 64]).toBe(255)
    expect(areas[0].weights.data[Math.floor(0.7 * 128) * 128 + 64]).toBe(0)
  })

  it('refuses a document with neither areas nor groups', () => {
    const document = parseStrokes({ version: 1, strokes: [line(0.3)] })
    expect(() => paintAreas(document, canvas)).toThrow(
      'paintAreas: the document has no areas, and no stroke has a group, allowed: at least one of them; give the strokes a group, or add "areas"',
    )
  })
})
