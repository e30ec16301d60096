import { type Stroke, StrokeLayer, skinCanvas } from 'furrow/author'
import { describe, expect, it, vi } from 'vitest'
import { LineGrid } from '../../../packages/furrow/src/author/strokes/line-grid.ts'
import { cylinder, uvOf } from './skins.ts'

/** Counts searches for lines around a texel. */
function searchesOf(action: () => unknown): number {
  const visit = vi.spyOn(LineGrid.prototype, 'visit')
  action()
  const count = visit.mock.calls.length
  visit.mockRestore()
  return count
}

describe('a layer of strokes', () => {
  const canvas = skinCanvas(cylinder(), 256)
  const line = (turns: number[], y: number): Stroke => ({
    curve: 'spline',
    points: turns.map((turn) => uvOf(turn, y)),
    width: 2,
    depth: 1,
    taper: [0, 0],
    shoulder: [0.6, 0.6],
    softness: 0.4,
    waviness: 0,
  })

  it('reports a rectangle on each side of a seam that a changed stroke crosses, and none without changes', () => {
    const layer = new StrokeLayer(canvas)
    const own = line([0.8, 0.95, 1.05, 1.2], 12)
    const changed = layer.draw([own]).sort((a, b) => a.x0 - b.x0)
    expect(changed.length).toBe(2)
    // The islands end and begin at 115 and 141. Both are extended by 14 texels, and slopes take two more.
    expect(changed[0].x1).toBeLessThanOrEqual(115 + 17)
    expect(changed[1].x0).toBeGreaterThanOrEqual(141 - 17)
    expect(layer.draw([own])).toEqual([])
    expect(layer.draw([{ ...own }])).toEqual([])
  })

  it('redraws only texels within reach of a changed stroke', () => {
    const layer = new StrokeLayer(canvas)
    const others = [5, 15, 45, 55].map((y) => line([0.2, 0.8], y))
    const own = line([0.3, 0.5], 30)
    layer.draw([...others, own])
    // Reach of 7 mm, in texels of 60 mm / (0.8 * 256), plus two for slopes.
    const most = 30 + 2 * (7 * (205 / 60) + 4)
    for (const { y0, y1 } of layer.draw([...others, { ...own, depth: 0.5 }]))
      expect(y1 - y0).toBeLessThan(most)
    // Overwritten texels elsewhere stay, so they were not redrawn.
    layer.heights.data.fill(9)
    layer.draw([...others, own])
    expect(layer.heights.data.filter((value) => value === 9).length).toBeGreaterThan(200 * 200)
  })

  it('searches the lines around a bent one only once', () => {
    const layer = new StrokeLayer(canvas)
    const others = [27, 29, 31, 33].map((y) => line([0.3, 0.6], y))
    const bent = (depth: number) => [
      ...others.slice(0, 2),
      { ...line([0.3, 0.5], 30), depth },
      ...others.slice(2),
    ]
    const searches = (strokes: readonly Stroke[]) => searchesOf(() => layer.draw(strokes))
    layer.draw(bent(1))
    const first = searches(bent(0.8))
    // First the bent line and all others in each texel, then only the bent line.
    expect(searches(bent(0.6))).toBe(first / 2)
    // Others that changed in between are searched again.
    layer.draw(bent(0.6).slice(1))
    expect(searches([...bent(0.5)].slice(1))).toBe(first)
  })

  it('searches the lines around a new one only once, also when it is bent, removed and drawn again', () => {
    const layer = new StrokeLayer(canvas)
    const others = [27, 29, 31, 33].map((y) => line([0.3, 0.6], y))
    const own = line([0.3, 0.5], 30)
    const searches = (strokes: readonly Stroke[]) => searchesOf(() => layer.draw(strokes))
    layer.draw(others)
    const first = searches([...others, own])
    const later = [
      searches([...others, { ...own, depth: 0.5 }]),
      searches(others),
      searches([...others, own]),
      searches(others.with(2, own)),
    ]
    expect(later.slice(0, 3)).toEqual([first / 2, first / 2, first / 2])
    // After two changes at once all lines are searched again.
    expect(later[3]).toBeGreaterThan(first / 2)
  })

  describe('prepared for a line', () => {
    const others = [10, 27, 29, 31, 33, 50].map((y) => line([0.3, 0.6], y))
    const draw = (layer: StrokeLayer, strokes: readonly Stroke[]) => searchesOf(() => layer.draw(strokes))
    const bent = (at: number) => others.with(at, { ...others[at], depth: 0.5 })
    const layerOf = (strokes: readonly Stroke[]) => {
      const layer = new StrokeLayer(canvas)
      layer.draw(strokes)
      return layer
    }

    it('has searched the lines around it before it is first bent', () => {
      const [layer, plain] = [layerOf(others), layerOf(others)]
      const found = searchesOf(() => [...layer.prepare(others[2])])
      const first = draw(plain, bent(2))
      // Only texels within the line's reach are searched.
      expect(found).toBe(first / 2)
      expect(draw(layer, bent(2))).toBe(first / 2)
      for (const map of ['heights', 'normal', 'occlusion'] as const) {
        const [own, other] = [layer, plain].map((each) => Buffer.from(each[map].data.buffer))
        expect(own.equals(other)).toBe(true)
      }
    })

    it('prepares in steps of a tile, and continues if the line is bent between steps', () => {
      const layer = layerOf(others)
      const steps = layer.prepare(others[2])
      const first = [1, 2, 3].map(() => searchesOf(() => steps.next()))
      for (const searches of first) expect(searches).toBeLessThanOrEqual(64)
      const full = draw(layerOf(others), bent(2))
      const found = first.reduce((sum, searches) => sum + searches)
      expect(draw(layer, bent(2))).toBe(full - found)
      expect(steps.next().done).toBe(false)
      expect(searchesOf(() => [...steps])).toBe(0)
    })

    it('stops when another line is prepared or edited, and ignores lines that are not drawn', () => {
      const layer = layerOf(others)
      const steps = layer.prepare(others[2])
      steps.next()
      layer.prepare(others[4]).next()
      expect(steps.next().done).toBe(true)
      const again = layer.prepare(others[2])
      again.next()
      layer.draw(bent(4))
      expect(again.next().done).toBe(true)
      expect(layer.prepare(others[4]).next().done).toBe(true)
    })
  })

  it('refuses a base of another size', () => {
    const base = { width: 128, height: 128, data: new Uint8Array(4 * 128 * 128) }
    expect(() => new StrokeLayer(canvas, { base })).toThrow('differs from the base map')
  })
})
