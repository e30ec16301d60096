import { autoWrinkleSet } from 'furrow/author'
import { expect, it } from 'vitest'

it('automatic wrinkles have heights at half resolution, with their amplitude in metres', () => {
  const gray = { width: 4, height: 4, data: new Uint8Array(16).fill(255) }
  const normal = { ...gray, data: new Uint8Array(64).fill(255) }
  // A bulge in one quarter of the map, and a valley twice as deep in another, millimetres.
  const data = Float32Array.from({ length: 16 }, (_, i) =>
    i % 4 < 2 && i < 8 ? 0.2 : i % 4 > 1 && i > 7 ? -0.4 : 0,
  )
  const layer = { name: 'a', strokes: [], normal, occlusion: gray, heights: { width: 4, height: 4, data } }
  const blood = { maps: [gray], areas: [], amplitude: 1 }
  const [made] = autoWrinkleSet({
    layers: [layer],
    areas: [],
    jointAreas: [],
    blood,
    bulges: [],
    furrows: undefined,
    expressions: [],
  }).layers
  expect(made.height).toEqual({ width: 2, height: 2, data: Uint8Array.of(191, 128, 128, 0) })
  expect(made.heightAmplitude).toBeCloseTo(0.0008, 9)
})
