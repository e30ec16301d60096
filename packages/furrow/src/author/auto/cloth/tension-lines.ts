import { Rng } from '../../../math/rng.ts'
import { length2 } from '../../../math/vector.ts'
import type { ChartSamples } from '../buckling/sample-chart.ts'
import type { Ridge } from './ridges.ts'

/** Number of lines in each quarter of the tube, on both sides of the hinge and of the limb. */
const COUNT = 2
/** Angles from the crook, in degrees, between which a line runs: from the tip of the elbow or the front of the knee to the side. */
const FROM = 158
const TO = [104, 84] as const
/** Distances from the hinge along the limb at both ends of a line, in radii. */
const START = [0.12, 0.5] as const
const END = [0.55, 1.25] as const
/** Height and reach in wavelengths. */
const HEIGHT = 0.065
const REACH = 0.5
/** Distance between points in wavelengths. */
const STEP = 0.06

/** Returns lines of cloth that a bend pulls: they start at the tip of the elbow or at the front of the knee. */
export function tensionLines(
  { grid: { width, height, spacing }, origin }: ChartSamples,
  { radius, wavelength, seed }: { radius: number; wavelength: number; seed: number },
): Ridge[] {
  const rng = new Rng(seed, 'tension')
  return [-1, 1].flatMap((side) =>
    [-1, 1].flatMap((half) =>
      Array.from({ length: COUNT }, (_, k): Ridge => {
        const degree = (side * radius * Math.PI) / 180
        const from = [degree * (FROM + rng.jitter(8)), half * radius * (START[k] + rng.jitter(0.1))]
        const to = [degree * (TO[k] + rng.jitter(10)), half * radius * (END[k] + rng.jitter(0.2))]
        const bow = half * radius * rng.jitter(0.12)
        const size = length2(to[0] - from[0], to[1] - from[1])
        const count = Math.max(3, Math.round(size / (STEP * wavelength)))
        const points: number[] = []
        const heights: number[] = []
        const tall = HEIGHT * wavelength * (1 + rng.jitter(0.35))
        for (let i = 0; i <= count; i++) {
          const t = i / count
          const x = from[0] + t * (to[0] - from[0]) - origin[0]
          const y = from[1] + t * (to[1] - from[1]) + 4 * bow * t * (1 - t) - origin[1]
          if (x < 0 || y < 0 || x > (width - 1) * spacing || y > (height - 1) * spacing) continue
          points.push(x, y)
          heights.push(tall)
        }
        const reach = REACH * wavelength
        return {
          points: Float64Array.from(points),
          heights: Float64Array.from(heights),
          reach: [reach, reach],
          joins: [false, false],
        }
      }).filter(({ heights }) => heights.length > 3),
    ),
  )
}
