import { paintAreas, parseStrokes } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { across } from '../../strokes.ts'
import { flatCanvas, same } from './planes.ts'

const line = (v: number, group?: string) => ({
  points: across(v, 0.2, 0.8),
  width: 2,
  depth: 0.5,
  ...(group && { group }),
})

// A texel is 1 mm wide, so the centre of texel i is at i + 0.5 mm.
const canvas = flatCanvas(128, 128, 128)
const square = [
  [0.25, 0.25],
  [0.75, 0.25],
  [0.75, 0.75],
  [0.25, 0.75],
]

const texels = Array.from({ length: 128 * 128 }, (_, i) => ({
  i,
  x: (i % 128) + 0.5,
  y: Math.floor(i / 128) + 0.5,
}))

function paint(areas: object[], strokes = [line(0.5, 'brow')]) {
  return paintAreas(parseStrokes({ version: 1, strokes, areas }), canvas)
}

describe('paintAreas', () => {
  it('is 255 inside a polygon, 0 outside, and half on the outline, with a smooth transition', () => {
    const [{ name, weights }] = paint([{ name: 'patch', shapes: [{ polygon: square, feather: 8 }] }])
    expect(name).toBe('patch')
    const wrong = texels.filter(({ i, x, y }) => {
      const inside = Math.min(x - 32, 96 - x, y - 32, 96 - y)
      const weight = weights.data[i]
      if (inside >= 4) return weight !== 255
      return inside <= -4 ? weight !== 0 : inside > 0 && weight <= 127
    })
    expect(wrong).toEqual([])
    // The centre of this texel is 0.5 mm inside, where the weight is `smoothstep(0.5 + 0.5 / 8)`.
    const t = 0.5 + 0.5 / 8
    expect(weights.data[64 * 128 + 32]).toBe(Math.round(255 * t * t * (3 - 2 * t)))
  })

  it('covers the skin within a radius around the strokes of a group', () => {
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

  it('takes the maximum of overlapping shapes', () => {
    const shape = { polygon: square, feather: 8 }
    const [once] = paint([{ name: 'a', shapes: [shape] }])
    const [twice] = paint([{ name: 'a', shapes: [shape, shape] }])
    expect(same(twice.weights.data, once.weights.data)).toBe(true)
  })

  it('can be split into two halves that add up to it, each 0 beyond the transition', () => {
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
    // Skips columns at the border of the map, where the polygon of a half also has a soft outline.
    const wrong = texels.filter(({ i, x }) => {
      if (x < 10 || x > 118) return false
      const [l, r] = [left.weights.data[i], right.weights.data[i]]
      const isBeyond = x < 64 - 5 ? l > 0 : x > 64 + 5 && r > 0
      return isBeyond || Math.abs(l + r - whole.weights.data[i]) > 1
    })
    expect(wrong).toEqual([])
    expect(left.weights.data[64 * 128 + 70]).toBe(255)
  })

  it('makes one area per group if the document describes none', () => {
    const document = parseStrokes({
      version: 1,
      strokes: [line(0.3, 'upper'), line(0.7, 'lower'), line(0.5), line(0.32, 'upper')],
    })
    const areas = paintAreas(document, canvas)
    expect(areas.map((area) => area.name)).toEqual(['upper', 'lower'])
    expect(areas[0].weights.data[Math.floor(0.3 * 128) * 128 + 64]).toBe(255)
    expect(areas[0].weights.data[Math.floor(0.7 * 128) * 128 + 64]).toBe(0)
  })

  it('shows bulges up to their feet if the document describes no areas', () => {
    const bulge = { ...line(0.5, 'bag'), depth: -1, width: 24 }
    const [area] = paintAreas(parseStrokes({ version: 1, strokes: [bulge] }), canvas)
    for (const y of [64 - 12, 64 + 11]) expect(area.weights.data[y * 128 + 64]).toBe(255)
    expect(area.weights.data[(64 + 21) * 128 + 64]).toBe(0)
  })

  it('refuses a document with neither areas nor groups', () => {
    const document = parseStrokes({ version: 1, strokes: [line(0.3)] })
    expect(() => paintAreas(document, canvas)).toThrow(
      'paintAreas: the document has no areas, and no stroke has a group, allowed: at least one of them; give the strokes a group, or add "areas"',
    )
  })
})
