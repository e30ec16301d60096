import type { GrayImage } from 'furrow'
import { Vector3 } from 'three'
import { expect, it } from 'vitest'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { circle } from '../../../../studio/src/tools/brush-ring.ts'
import { type PaintTarget, PaintTool } from '../../../../studio/src/tools/paint-tool.ts'
import { empty, pickerOf, plainSheet, pointerAt } from './skins.ts'

const SIZE = 64
const image = empty(SIZE)

/** Creates a tool on a sheet, and records the weights that it shows and stores, and its requests. */
function toolOnSheet() {
  const { skin, picker } = pickerOf(plainSheet())
  const [shown, kept]: GrayImage[][] = [[], []]
  const calls = { paint: 0, hits: [] as boolean[] }
  const show = (weights: GrayImage) => shown.push({ ...weights, data: weights.data.slice() })
  const tool = new PaintTool<PaintTarget>({
    target: () => ({ name: 'cheek', image, brush: BRUSH_DEFAULTS, skin, picker }),
    preparation: () => null,
    onPaint: () => calls.paint++,
    show: (_, weights) => show(weights),
    keep: (_, weights) => kept.push(weights),
    discard: (target) => show(target.image),
    onHit: (hit) => calls.hits.push(hit !== null),
  })
  return { tool, shown, kept, calls }
}

const total = ({ data }: GrayImage) => data.reduce((sum, weight) => sum + weight, 0)

it('shows the stroke once per frame while it grows, and stores it once at its end', () => {
  const { tool, shown, kept, calls } = toolOnSheet()
  expect(tool.begin(pointerAt(0, 0))).toBe(true)
  tool.move([pointerAt(0.01, 0), pointerAt(0.02, 0)])
  tool.move([pointerAt(0.03, 0)])
  expect(shown).toEqual([])
  expect(calls.paint).toBe(3)
  tool.showStroke()
  tool.showStroke()
  expect(shown.length).toBe(1)
  tool.end()
  expect(kept.length).toBe(1)
  expect(total(kept[0])).toBe(total(shown[0]))
  expect(total(kept[0])).toBeGreaterThan(0)
  expect(total(image)).toBe(0)
})

it('restores the old weights after a stroke is cancelled, and stores nothing', () => {
  const { tool, shown, kept } = toolOnSheet()
  tool.begin(pointerAt(0, 0))
  tool.showStroke()
  tool.cancel()
  tool.end()
  expect(shown.map(total)).toEqual([total(shown[0]), 0])
  expect(kept).toEqual([])
})

it('leaves the pointer to the camera if it is off the face, or with Alt', () => {
  const { tool } = toolOnSheet()
  expect(tool.begin(pointerAt(0.2, 0))).toBe(false)
  expect(tool.begin(pointerAt(0, 0, { alt: true }))).toBe(false)
})

it('does not store a stroke that changes no weight', () => {
  const { tool, kept } = toolOnSheet()
  tool.begin(pointerAt(0, 0, { pressure: 0 }))
  tool.end()
  expect(kept).toEqual([])
})

it('reports the brush position over the face, and when the brush leaves', () => {
  const { tool, calls } = toolOnSheet()
  tool.hover(pointerAt(0, 0))
  tool.hover(pointerAt(0.2, 0))
  tool.hover(null)
  expect(calls.hits).toEqual([true, false, false])
})

it.each([
  [0, 0, 1],
  [1, 0, 0],
  [0.6, 0.8, 0],
])('the outline of the brush is perpendicular to the normal %f, %f, %f', (...components) => {
  const [centre, normal] = [new Vector3(1, 2, 3), new Vector3(...components)]
  for (const corner of circle(centre, normal, 0.5)) {
    expect(corner.distanceTo(centre)).toBeCloseTo(0.5, 9)
    expect(corner.sub(centre).dot(normal)).toBeCloseTo(0, 9)
  }
})
