import { atan2, cos, power, sin } from '../../../math/elementary.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { withFineEnds } from './fine-ends.ts'
import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  SIDES,
  type Side,
  sampleCurve,
} from './region.ts'

/** Returns the regions around the eyes: crow's feet, and fine lines below the lower lid (orbicularis oculi muscle). */
export function eyes(context: FaceContext): FaceRegion[] {
  return SIDES.flatMap(([side, name]) => [crowsFeet(context, side, name), underEye(context, side, name)])
}

/** Creates crow's feet: a fan of long lines from the outer corner of the eye, finer lines between their outer parts, and a fork. */
function crowsFeet({ landmarks, byAge, rngOf }: FaceContext, side: Side, name: string): FaceRegion {
  const rng = rngOf(`crowsFeet${name}`)
  const [corner, up] = chartPointOf(landmarks.outerCorner)
  const lines = Math.round(byAge(3, 5))
  /** Creates a line of the fan: t = 0 is the uppermost line, t = 1 the lowest one. `start` and `length` are in millimetres. */
  const ray = (t: number, start: number, length: number): ChartPoint[] => {
    const rise = 27 - 75 * t
    // Like the ring-shaped muscle, upper lines bend up at their outer ends, and lower lines bend down.
    const bend = 0.35 * rise + rng.jitter(6)
    const [wave, phase] = [rng.jitter(9), rng.uniform(0, 2 * Math.PI)]
    return walk(side, [corner + start * cosOf(rise), up + start * sinOf(rise)], length, (s) => {
      const along = s * length
      return rise + bend * s + wave * sin(along / 7 + phase) + RIPPLE * sin(along / 2.6 - phase)
    })
  }
  const long = Array.from({ length: lines }, (_, i): Guide => {
    const t = (i + rng.jitter(0.14)) / (lines - 1)
    const strength = 1 - 0.45 * power(Math.abs(2 * t - 0.9), 1.6)
    const length = byAge(24, 38) * (0.7 + 0.3 * strength) * rng.uniform(0.85, 1.12)
    return {
      path: ray(t, 6.5 + 2 * Math.abs(2 * t - 1) + rng.jitter(1), length),
      width: byAge(1.4, 1.9) * (0.85 + 0.15 * strength),
      depth: strength,
      taper: [0.25, 0.6],
      shoulder: [1, 1],
      softness: byAge(0.5, 0.4),
    }
  })
  const fine = long.slice(1).flatMap((_, i): Guide[] => {
    if (rng.next() > byAge(0.2, 1)) return []
    const t = (i + 0.5 + rng.jitter(0.1)) / (lines - 1)
    const path = ray(t, rng.uniform(11, 15), byAge(9, 17) * rng.uniform(0.8, 1.2))
    return [{ ...BRANCH, path, depth: rng.uniform(0.35, 0.55) }]
  })
  const stem = long[Math.floor(lines / 2)].path
  const index = Math.round(rng.uniform(0.35, 0.5) * stem.length)
  const [start, before] = [stem[index], stem[index - 1]]
  const rise = degreesOf(side * (start[0] - before[0]), start[1] - before[1])
  const fork: Guide = {
    ...BRANCH,
    path: walk(side, [side * start[0], start[1]], byAge(9, 14), (t) => rise + 24 - 10 * t),
    depth: 0.55,
  }
  const guides = [...withFineEnds(long, byAge(0.2, 0.6), rngOf(`crowsFeet${name} ends`)), ...fine, fork]
  return {
    name: `crowsFeet${name}`,
    cause: { [`eyeSquint${name}`]: 0.6, [`cheekSquint${name}`]: 1, [`mouthSmile${name}`]: 0.6 },
    guides,
    spacing: 4.5,
    creasedFraction: byAge(0.35, 0.85),
    maxDepth: byAge(0.5, 0.85),
    atRest: 0.6,
    reach: 4,
    feather: 6,
  }
}

/** Creates arcs below the lower lid, finer than crow's feet. */
function underEye({ landmarks, byAge, rngOf }: FaceContext, side: Side, name: string): FaceRegion {
  const rng = rngOf(`underEye${name}`)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const [outer] = chartPointOf(landmarks.outerCorner)
  const eye = landmarks.eye[1]
  const lines = Math.round(byAge(3, 4))
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const from = inner + 3 + 2.5 * i + rng.jitter(1)
    const to = outer - 4 + 1.6 * i + rng.jitter(1)
    const up = eye - 9.5 - 2.7 * i
    return {
      path: bezierPath(
        side,
        [from, up],
        [from + (to - from) / 3, up - 2.6 - 0.5 * i],
        [from + (2 * (to - from)) / 3, up - 2.2 - 0.4 * i],
        [to, up + 1.5 - 0.5 * i],
      ),
      width: byAge(1.3, 1.6),
      depth: 1 - 0.16 * i,
      taper: [0.5, 0.5],
      shoulder: [0.8, 0.8],
      softness: 0.6,
    }
  })
  return {
    name: `underEye${name}`,
    cause: { [`eyeSquint${name}`]: 1, [`cheekSquint${name}`]: 0.7 },
    guides,
    spacing: 3,
    creasedFraction: byAge(0.2, 0.55),
    maxDepth: byAge(0.2, 0.4),
    atRest: 0.5,
    reach: 2.5,
    feather: 4,
  }
}

/** Style of fine lines: forks, and lines between two long lines. */
const BRANCH = { width: 1.3, taper: [0.3, 0.6], shoulder: [0.8, 0.8], softness: 0.5 } as const

/**
 * Traces a curve outwards, away from the middle of the face.
 *
 * @param length length of the curve in millimetres.
 * @param rise returns the direction of the curve in degrees above the horizontal, at a fraction t of its length.
 */
function walk(side: Side, [x, y]: ChartPoint, length: number, rise: (t: number) => number): ChartPoint[] {
  let [across, up] = [x, y]
  return sampleCurve(STEPS, (t): ChartPoint => {
    if (t > 0) {
      across += (length / (STEPS - 1)) * cosOf(rise(t))
      up += (length / (STEPS - 1)) * sinOf(rise(t))
    }
    return [side * across, up]
  })
}

const STEPS = 20
/** Amplitude, in degrees, of the short waves of crow's feet. */
const RIPPLE = 5

const degreesOf = (across: number, up: number) => (atan2(up, across) * 180) / Math.PI
const cosOf = (degrees: number) => cos((degrees * Math.PI) / 180)
const sinOf = (degrees: number) => sin((degrees * Math.PI) / 180)
