import type { Spot } from '../chart.ts'
import { type Build, bezier, curve, type Guide, grown, type Region, SIDES, spotOf } from './region.ts'

/** Round the eyes: crow's feet and the fine lines below the lower lid (orbicularis oculi). */
export function eyes(build: Build): Region[] {
  return SIDES.flatMap(([side, name]) => [crowsFeet(build, side, name), underEye(build, side, name)])
}

/** A fan from the outer corner. */
function crowsFeet({ landmarks, age, random }: Build, side: 1 | -1, name: string): Region {
  const numbers = random(`crowsFeet${name}`)
  const [corner, up] = spotOf(landmarks.outerCorner)
  const lines = Math.round(grown(age, 3, 5))
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const share = (i + numbers.sway(0.12)) / (lines - 1)
    const degrees = 32 - 80 * share
    const strength = 1 - 0.55 * Math.abs(2 * share - 0.9) ** 1.6
    const length = grown(age, 24, 44) * (0.65 + 0.35 * strength) * numbers.between(0.9, 1.1)
    const first = 6.5 + 1.5 * Math.abs(2 * share - 1)
    // The outer ends bend on, up above and down below, as the muscle's ring does.
    const bend = degrees * 0.45 + numbers.sway(5)
    let [x, y] = [corner + first * cos(degrees), up + first * sin(degrees)]
    return {
      spots: curve(14, (t): Spot => {
        if (t > 0) {
          x += (length / 13) * cos(degrees + bend * t)
          y += (length / 13) * sin(degrees + bend * t)
        }
        return [side * x, y]
      }),
      width: grown(age, 2.4, 3),
      depth: strength,
      taper: [0.22, 0.6],
      shoulder: [0.9, 0.9],
      softness: grown(age, 0.5, 0.4),
    }
  })
  // One of the middle lines forks.
  const stem = guides[Math.floor(lines / 2)]!.spots
  const fork = stem[5]!
  guides.push({
    spots: bezier(
      1,
      fork,
      [fork[0] + side * 3, fork[1] + 0.4],
      [fork[0] + side * 6, fork[1] + 2],
      [fork[0] + side * grown(age, 8, 12), fork[1] + 4.4],
    ),
    width: 1.9,
    depth: 0.5,
    taper: [0.25, 0.6],
    shoulder: [0.8, 0.8],
    softness: 0.5,
  })
  return {
    name: `crowsFeet${name}`,
    cause: { [`eyeSquint${name}`]: 0.6, [`cheekSquint${name}`]: 1, [`mouthSmile${name}`]: 0.6 },
    guides,
    spacing: 5,
    hidden: grown(age, 0.35, 0.85),
    deepest: grown(age, 0.5, 0.85),
    reach: 4,
    feather: 6,
  }
}

/** Arcs that follow the lower lid, finer than the others. */
function underEye({ landmarks, age, random }: Build, side: 1 | -1, name: string): Region {
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

const cos = (degrees: number) => Math.cos((degrees * Math.PI) / 180)
const sin = (degrees: number) => Math.sin((degrees * Math.PI) / 180)
