import { afterEach, describe, expect, it, vi } from 'vitest'
import { LineOverlay, visibleParts } from '../../../../studio/src/lines/line-overlay.ts'
import type { ProjectedLine } from '../../../../studio/src/lines/project-lines.ts'
import { strokeOf } from '../sample-document.ts'

/** Line with points 0.5 pixels apart, each seen or hidden. */
const line = (isSeen: boolean[]) => ({
  x: Float32Array.from(isSeen, (_, i) => i / 2),
  y: new Float32Array(isSeen.length),
  isSeen,
})

describe('a line over the face', () => {
  it('is drawn through points three pixels apart, including its first and last', () => {
    expect(visibleParts(line(Array(16).fill(true)))).toEqual([[0, 6, 12, 15]])
    expect(visibleParts(line([true, true]))).toEqual([[0, 1]])
  })

  it('is drawn as one part for each visible stretch, up to the first hidden point', () => {
    const isSeen = [true, true, false, false, ...Array(9).fill(true), false, false]
    expect(visibleParts(line(isSeen))).toEqual([
      [0, 2],
      [4, 10, 13],
    ])
    expect(visibleParts(line([false, false]))).toEqual([])
  })

  describe('among others', () => {
    afterEach(() => vi.unstubAllGlobals())

    it('is hovered, selected and drawn again without redrawing the others until they move', () => {
      /** Number of curves drawn on each canvas, including their shadows. */
      const strokes: number[] = []
      const createElement = () => {
        const own = strokes.push(0) - 1
        const stroke = () => strokes[own]++
        const context = new Proxy(
          {},
          { get: (_, key) => (key === 'stroke' ? stroke : () => {}), set: () => true },
        )
        return { getContext: () => context }
      }
      vi.stubGlobal('document', { createElement })
      vi.stubGlobal('devicePixelRatio', 1)
      const overlay = new LineOverlay({
        clientWidth: 9,
        clientHeight: 9,
        after() {},
      } as unknown as HTMLElement)
      const projected = (): ProjectedLine => ({
        ...line([true, true]),
        stroke: strokeOf('up', 'forehead'),
        along: Float64Array.of(0, 1),
      })
      const lines = [projected(), projected(), projected()]
      const [first, second] = lines
      const rest = {
        lines,
        chosen: [first.stroke],
        point: -1,
        handles: [],
        weights: [],
        forks: [],
        hovered: null,
        path: [],
      }
      const drawnBy = (picture: Partial<typeof rest> | { hovered: ProjectedLine['stroke'] }) => {
        const before = [...strokes]
        overlay.draw({ ...rest, ...picture })
        return strokes.map((count, i) => count - before[i])
      }
      expect(drawnBy({})).toEqual([2, 4])
      expect(drawnBy({ hovered: second.stroke })).toEqual([4, 0])
      expect(drawnBy({ lines: [projected(), ...lines] })).toEqual([2, 6])
      expect(drawnBy({ lines: [first] })).toEqual([2, 0])
    })
  })
})
