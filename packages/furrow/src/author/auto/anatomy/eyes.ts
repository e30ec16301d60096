import type { Spot } from '../chart.ts'
import {
  type Build,
  bezier,
  curve,
  type Guide,
  grown,
  type Region,
  SIDES,
  type Side,
  spotOf,
} from './region.ts'

/** Round the eyes: crow's feet and the fine lines below the lower lid (orbicularis oculi). */
export function eyes(build: Build): Region[] {
  return SIDES.flatMap(([side, name]) => [crowsFeet(build, side, name), underEye(build, side, name)])
}

/** A fan from the outer corner: long lines, finer ones that begin farther out between them, and one that forks. */
function crowsFeet({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`crowsFeet${name}`)
  const [corner, up] = spotOf(landmarks.outerCorner)
  const lines = Math.round(grown(age, 3, 5))
  /** From the uppermost, 0, to the lowest, 1; begins so many millimetres away from the corner. */
  const ray = (share: number, first: number, length: number): Spot[] => {
    const rise = 27 - 75 * share
    // The outer ends bend on, up above and down below, as the muscle's ring does.
    const bend = 0.35 * rise + numbers.sway(6)
    const [wave, phase] = [numbers.sway(8), numbers.between(0, 2 * Math.PI)]
    return walk(side, [corner + first * cos(rise), up + first * sin(rise)], length, (t) => {
      return rise + bend * t + wave * Math.sin(5 * t + phase)
    })
  }
  const long = Array.from({ length: lines }, (_, i): Guide => {
    const share = (i + numbers.sway(0.14)) / (lines - 1)
    const strength = 1 - 0.45 * Math.abs(2 * share - 0.9) ** 1.6
    const length = grown(age, 24, 46) * (0.7 + 0.3 * strength) * numbers.between(0.85, 1.12)
    return {
      spots: ray(share, 6.5 + 2 * Math.abs(2 * share - 1) + numbers.sway(1), length),
      width: grown(age, 2, 2.6) * (0.85 + 0.15 * strength),
      depth: strength,
      taper: [0.25, 0.6],
      shoulder: [0.9, 0.9],
      softness: grown(age, 0.5, 0.4),
    }
  })
  const fine = long.slice(1).flatMap((_, i): Guide[] => {
    if (numbers.next() > grown(age, 0.2, 1)) return []
    const share = (i + 0.5 + numbers.sway(0.1)) / (lines - 1)
    const spots = ray(share, numbers.between(11, 15), grown(age, 9, 17) * numbers.between(0.8, 1.2))
    return [{ ...BRANCH, spots, depth: numbers.between(0.35, 0.55) }]
  })
  const stem = long[Math.floor(lines / 2)]!.spots
  const at = Math.round(numbers.between(0.35, 0.5) * stem.length)
  const [from, before] = [stem[at]!, stem[at - 1]!]
  const way = degreesOf(side * (from[0] - before[0]), from[1] - before[1])
  const fork: Guide = {
    ...BRANCH,
    spots: walk(side, [side * from[0], from[1]], grown(age, 9, 14), (t) => way + 24 - 10 * t),
    depth: 0.55,
  }
  const guides = [...long, ...fine, fork]
  return {
    name: `crowsFeet${name}`,
    cause: { [`eyeSquint${name}`]: 0.6, [`cheekSquint${name}`]: 1, [`mouthSmile${name}`]: 0.6 },
    guides,
    spacing: 4.5,
    hidden: grown(age, 0.35, 0.85),
    deepest: grown(age, 0.5, 0.85),
    reach: 4,
    feather: 6,
  }
}

/** Arcs that follow the lower lid, finer than the others. */
function underEye({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`underEye${name}`)
  const [inner] = spotOf(landmarks.innerCorner)
  const [outer] = spotOf(landmarks.outerCorner)
  const eye = landmarks.eye[1]
  const lines = Math.round(grown(age, 3, 4))
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const from = inner + 3 + 2.5 * i + numbers.sway(1)
    const to = outer - 4 + 1.6 * i + numbers.sway(1)
    const up = eye - 9.5 - 2.7 * i
    return {
      spots: bezier(
        side,
        [from, up],
        [from + (to - from) / 3, up - 2.6 - 0.5 * i],
        [from + (2 * (to - from)) / 3, up - 2.2 - 0.4 * i],
        [to, up + 1.5 - 0.5 * i],
      ),
      width: grown(age, 1.7, 2.2),
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
    hidden: grown(age, 0.2, 0.55),
    deepest: grown(age, 0.2, 0.4),
    reach: 2.5,
    feather: 4,
  }
}

/** What leaves a line, or lies between two. */
const BRANCH = { width: 1.7, taper: [0.3, 0.6], shoulder: [0.8, 0.8], softness: 0.5 } as const

/** Points of a walk outwards and, from 0 to 1 of its length, in a direction of so many degrees above the horizontal. */
function walk(side: Side, [x, y]: Spot, length: number, rise: (t: number) => number): Spot[] {
  let [across, up] = [x, y]
  return curve(WALK, (t): Spot => {
    if (t > 0) {
      across += (length / (WALK - 1)) * cos(rise(t))
      up += (length / (WALK - 1)) * sin(rise(t))
    }
    return [side * across, up]
  })
}

const WALK = 20

const degreesOf = (across: number, up: number) => (Math.atan2(up, across) * 180) / Math.PI
const cos = (degrees: number) => Math.cos((degrees * Math.PI) / 180)
const sin = (degrees: number) => Math.sin((degrees * Math.PI) / 180)
