import { type Stroke, skinCanvas, smoothStroke } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { cylinder, placeOf, strokeOn } from './skins.ts'

const skin = skinCanvas(cylinder(), 64)

const turns = Array.from({ length: 13 }, (_, i) => 0.4 + 0.1 * i)
/** Heights of an arc that is 8 mm high, across the seam. */
const arc = turns.map((_, i) => 20 + 8 * (1 - ((i - 6) / 6) ** 2))
/** Deviations of a trembling hand, millimetres. They are 0 at the ends. */
const TREMOR = [0, 0.9, -0.7, 0.8, -0.9, 0.4, -0.8, 0.9, -0.5, 0.7, -0.9, 0.8, 0]

const heightsOf = ({ points }: Stroke) => points.map((uv) => placeOf(uv)[1])
const rms = (values: readonly number[]) =>
  Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length)

describe('a smoothed stroke', () => {
  const shaky = strokeOn(turns.map((turn, i) => [turn, arc[i] + TREMOR[i]]))

  it.each([1, 5])('keeps its bend and loses its tremor, smoothed %d times', (times) => {
    let smooth = shaky
    for (let n = 0; n < times; n++) smooth = smoothStroke(smooth, 0.8, skin)
    const heights = heightsOf(smooth)
    expect(Math.abs(Math.max(...heights) - 28)).toBeLessThan(0.05 * 8)
    expect(rms(heights.map((height, i) => height - arc[i]))).toBeLessThan(0.5 * rms(TREMOR))
    expect([smooth.points[0], smooth.points.at(-1)]).toEqual([shaky.points[0], shaky.points.at(-1)])
  })

  it('keeps a smooth arc, also with unevenly spaced points', () => {
    const uneven = [0.4, 0.45, 0.6, 0.65, 0.8, 1, 1.1, 1.3, 1.35, 1.5, 1.6]
    const arcAt = (turn: number) => 20 + 8 * (1 - ((turn - 1) / 0.6) ** 2)
    const smooth = smoothStroke(strokeOn(uneven.map((turn) => [turn, arcAt(turn)])), 1, skin)
    for (const uv of smooth.points) {
      const [turn, y] = placeOf(uv)
      expect(Math.abs(y - arcAt(turn))).toBeLessThan(0.4)
    }
  })

  it('stays if it has too few points to tell a bend from a tremor', () => {
    const bent = strokeOn([[0.5, 20], [0.7, 30], [0.9, 20]]) // biome-ignore format: one line
    expect(smoothStroke(bent, 1, skin)).toBe(bent)
  })
})
