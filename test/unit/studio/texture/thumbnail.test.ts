import { expect, it } from 'vitest'
import { cropOf, shrink } from '../../../../studio/src/texture/thumbnail.ts'
import { empty } from '../paint/skins.ts'

function withRectangle(size: number, x0: number, y0: number, x1: number, y1: number) {
  const image = empty(size)
  for (let y = y0; y < y1; y++) image.data.fill(255, y * size + x0, y * size + x1)
  return image
}

it('a small area is shown with its surroundings, inside the texture', () => {
  const { x, y, side } = cropOf(withRectangle(100, 0, 48, 4, 52))
  expect(side).toBe(0.35)
  expect(x).toBe(0)
  expect(y).toBeCloseTo(0.5 - side / 2)
})

it('a large area is shown completely, and an empty one shows the whole texture', () => {
  expect(cropOf(withRectangle(100, 5, 5, 95, 50)).side).toBe(1)
  expect(cropOf(withRectangle(100, 30, 40, 80, 50))).toEqual({ x: 0.55 - 0.325, y: 0.45 - 0.325, side: 0.65 })
  expect(cropOf(empty(16))).toEqual({ x: 0, y: 0, side: 1 })
})

it('a pixel is the average of its texels, at larger and smaller sizes', () => {
  const image = withRectangle(8, 0, 0, 3, 8)
  expect([...shrink(image, { x: 0, y: 0, side: 1 }, 4).data.subarray(0, 4)]).toEqual([255, 127, 0, 0])
  expect([...shrink(image, { x: 0, y: 0, side: 0.5 }, 8).data.subarray(0, 8)]).toEqual([
    255, 255, 255, 255, 255, 255, 0, 0,
  ])
})
