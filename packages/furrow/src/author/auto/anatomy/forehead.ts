import { exp, power, sin } from '../../../math/elementary.ts'
import { smoothstep } from '../../../math/scalar.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { withFineEnds } from './fine-ends.ts'
import {
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  SIDES,
  type Side,
  sampleCurve,
} from './region.ts'

/** Half the width, in millimetres, of the transition between the left and the right areas. */
const MIDDLE = 4
/** Half the width, in millimetres, of the transition between an inner and an outer area. */
const HALVES = 9

/**
 * Returns the regions of the forehead: horizontal lines, one above the other, that dip between the brows and arch over the brows (frontalis
 * muscle). Four areas show parts of the same lines, because the inner and outer ends of both brows rise independently.
 */
export function forehead({ landmarks, byAge, rngOf }: FaceContext): FaceRegion[] {
  const rng = rngOf('forehead')
  const inner = chartPointOf(landmarks.innerBrow)
  const outer = chartPointOf(landmarks.outerBrow)
  const brow = (inner[1] + outer[1]) / 2
  const height = landmarks.hairline - brow
  const lines = Math.round(byAge(4, 6))
  const guides: Guide[] = []
  for (let i = 0; i < lines; i++) {
    const t = (i + rng.jitter(0.12)) / (lines - 1)
    // The uppermost and lowest lines are shorter and shallower than the others.
    const strength = 1 - 0.5 * power(Math.abs(2 * t - 0.8), 1.5)
    const reach = Math.abs(outer[0]) * (0.78 + 0.3 * strength) + rng.jitter(5)
    const level = brow + height * (0.2 + 0.58 * t)
    const [longWave, shortWave, phase] = [rng.jitter(1.1), rng.jitter(1.1), rng.next() * 6.28]
    const pointAt = (across: number): ChartPoint => {
      const dip = (3.2 - 2.2 * t) * exp(-((across / 13) ** 2))
      const fall = (2.5 + 5.5 * t) * power(Math.abs(across) / 50, 2.2)
      const wave = longWave * sin(across / 13 + phase) + shortWave * sin(across / 7.3 - phase)
      return [across, level - dip - fall + wave]
    }
    const start = -(reach + rng.jitter(4))
    // Most lines consist of two pieces that overlap.
    const isBroken = rng.next() < 0.65
    const gap = rng.jitter(0.75 * reach)
    const pieces = isBroken
      ? [
          [start, gap + rng.uniform(2, 5), rng.uniform(-1.3, -0.6)],
          [gap - rng.uniform(2, 5), reach, rng.uniform(0.6, 1.3)],
        ]
      : [[start, reach, 0]]
    for (const [from, to, lift] of pieces) {
      const length = to - from
      guides.push({
        path: sampleCurve(32, (s) => {
          const [across, up] = pointAt(from + s * length)
          return [across, up + lift]
        }),
        width: byAge(2.8, 3.5) * (0.85 + 0.2 * strength),
        depth: strength * rng.uniform(0.85, 1),
        taper: [Math.min(0.5, 16 / length), Math.min(0.5, 16 / length)],
        shoulder: [1, 1],
        softness: byAge(0.55, 0.4),
      })
    }
    if (i > 0 && rng.next() < byAge(0.45, 0.9))
      guides.push(shortLine(pointAt, height / lines, reach, rng.jitter(0.6), byAge(0.25, 0.42)))
  }
  const withEnds = withFineEnds(guides, byAge(0.25, 0.6), rngOf('forehead ends'))
  const region = (side: Side, sideName: string, half: 'Inner' | 'Outer'): FaceRegion => ({
    name: `forehead${half}${sideName}`,
    cause:
      half === 'Inner'
        ? { browInnerUp: 1, [`browOuterUp${sideName}`]: 0.5 }
        : { [`browOuterUp${sideName}`]: 1, browInnerUp: 0.4 },
    expression: { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 },
    guides: withEnds,
    spacing: height / lines,
    creasedFraction: byAge(0.45, 0.9),
    maxDepth: byAge(0.8, 1.35),
    atRest: 0.3,
    reach: 6,
    feather: 7,
    influence: ([across]) => {
      const ownSide = smoothstep((side * across + MIDDLE) / (2 * MIDDLE))
      const outerHalf = smoothstep((side * across - 0.42 * Math.abs(outer[0]) + HALVES) / (2 * HALVES))
      return ownSide * (half === 'Outer' ? outerHalf : 1 - outerHalf)
    },
  })
  return SIDES.flatMap(([side, name]) => [region(side, name, 'Inner'), region(side, name, 'Outer')])
}

/** Creates a short, faint line halfway between the line `pointAt` and the next lower line. */
function shortLine(
  pointAt: (across: number) => ChartPoint,
  spacing: number,
  reach: number,
  centre: number,
  depth: number,
): Guide {
  const middle = centre * reach
  const half = 0.3 * reach
  return {
    path: sampleCurve(16, (t) => {
      const [across, up] = pointAt(middle + (2 * t - 1) * half)
      return [across, up - 0.5 * spacing]
    }),
    width: 2,
    depth,
    taper: [0.5, 0.5],
    shoulder: [0.8, 0.8],
    softness: 0.6,
  }
}
