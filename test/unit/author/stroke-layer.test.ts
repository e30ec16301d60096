import { type Stroke, StrokeLayer, skinCanvas, strokesToOnset } from 'furrow/author'
import { describe, expect, it, vi } from 'vitest'
import { LineGrid } from '../../../packages/furrow/src/author/strokes/line-grid.ts'
import { cylinder, uvOf } from './skins.ts'

/** Counts how often an action searches for the lines near a texel. */
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
    // The left island ends at column 115, and the right one begins at 141. Heights are drawn up to 14 texels beyond an island. A slope depends
    // on heights up to 2 texels away, so slopes change up to 16 texels beyond an island.
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
    // A stroke reaches 7 mm, and a texel is 60 mm / (0.8 * 256) high. The margin of 4 texels allows for slopes and rounding.
    const most = 30 + 2 * (7 * (205 / 60) + 4)
    for (const { y0, y1 } of layer.draw([...others, { ...own, depth: 0.5 }]))
      expect(y1 - y0).toBeLessThan(most)
    // Sets all heights to 9. Texels that keep the 9 were not redrawn.
    layer.heights.data.fill(9)
    layer.draw([...others, own])
    expect(layer.heights.data.filter((value) => value === 9).length).toBeGreaterThan(200 * 200)
  })

  it('searches the lines around a stroke only in the first of several changes of that stroke', () => {
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
    // The first change searches twice per texel: once for the other lines, and once for the changed line. Later changes skip the first search.
    expect(searches(bent(0.6))).toBe(first / 2)
    // After a change of another line, all lines are searched again.
    layer.draw(bent(0.6).slice(1))
    expect(searches([...bent(0.5)].slice(1))).toBe(first)
  })

  it('searches the lines around a new stroke only once, also if the stroke is changed, removed and drawn again', () => {
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

    it('searches for the neighbours of a line in `prepare`, not at the first change of the line', () => {
      const [layer, plain] = [layerOf(others), layerOf(others)]
      const found = searchesOf(() => [...layer.prepare(others[2])])
      const first = draw(plain, bent(2))
      // The preparation searches only texels within the reach of the line.
      expect(found).toBe(first / 2)
      expect(draw(layer, bent(2))).toBe(first / 2)
      for (const map of ['heights', 'normal', 'occlusion'] as const) {
        const [own, other] = [layer, plain].map((each) => Buffer.from(each[map].data.buffer))
        expect(own.equals(other)).toBe(true)
      }
    })

    it('prepares one tile of texels per step, and continues if the line is changed between steps', () => {
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

    it('stops when another line is prepared or edited, and does nothing for a line that is not drawn', () => {
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

  it('redraws the onset of a whole group when its deepest line changes, and otherwise only around changed lines', () => {
    const layer = new StrokeLayer(canvas, { onset: true })
    const named = (own: Stroke, group: string): Stroke => ({ ...own, group })
    const apart = [5, 30, 55].map((y) => named(line([0.3, 0.5], y), 'brow'))
    const other = named(line([0.3, 0.5], 42), 'chin')
    const sameAsRedrawn = (strokes: readonly Stroke[]) => {
      const changed = layer.draw(strokes)
      expect(Buffer.from(layer.onset!.data).equals(strokesToOnset(strokes, canvas).data)).toBe(true)
      return changed
    }
    sameAsRedrawn([...apart, other])
    const rows = (changed: ReturnType<typeof layer.draw>) =>
      Math.max(...changed.map(({ y1 }) => y1)) - Math.min(...changed.map(({ y0 }) => y0))
    const deeper = apart.with(1, { ...apart[1], depth: 2 })
    expect(rows(sameAsRedrawn([...deeper, other]))).toBeGreaterThan(150)
    const bent = deeper.with(0, named(line([0.3, 0.55], 6), 'brow'))
    expect(rows(sameAsRedrawn([...bent, other]))).toBeLessThan(80)
    sameAsRedrawn(bent.toSpliced(1, 1))
    sameAsRedrawn([])
    expect(layer.onset!.data.every((byte) => byte === 0)).toBe(true)
  })

  it('refuses a base of another size', () => {
    const base = { width: 128, height: 128, data: new Uint8Array(4 * 128 * 128) }
    expect(() => new StrokeLayer(canvas, { base })).toThrow('differs from the base map')
  })
})
