import { smoothstep } from '../../../math/scalar.ts'
import { type Build, bezier, type Guide, grown, type Region, SIDES, type Side, spotOf } from './region.ts'

/** Half the width in millimetres in which left and right pass into one another. */
const MIDDLE = 2

/** Between the brows: an upright line on each side, a second one with age (corrugator); and one across the root of the nose (procerus). */
export function frown(build: Build): Region[] {
  return [...SIDES.map(([side, name]) => glabella(build, side, name)), noseRoot(build)]
}

function glabella({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`glabella${name}`)
  const [inner, brow] = spotOf(landmarks.innerBrow)
  const across = 0.5 * inner + numbers.sway(0.5)
  const line = (at: number, low: number, high: number, width: number, depth: number): Guide => ({
    // It leans outwards above and bends towards the nose below.
    spots: bezier(
      side,
      [at - 0.6, brow + low],
      [at + 0.3, brow + low + 6],
      [at, brow + high - 8],
      [at + 1.6, brow + high],
    ),
    width,
    depth,
    taper: [0.4, 0.5],
    shoulder: [0.9, 0.9],
    softness: grown(age, 0.5, 0.35),
  })
  const guides = [line(across, -8 + numbers.sway(1), 15 + numbers.sway(2), grown(age, 4.2, 5.4), 1)]
  if (age > 0.2)
    guides.push(line(across + 4.6 + numbers.sway(0.5), -2, 11 + numbers.sway(2), 2.6, grown(age, 0.35, 0.6)))
  if (age > 0.5) guides.push(line(across - 3.6, -1, 9 + numbers.sway(2), 2.2, 0.35))
  return {
    name: `glabella${name}`,
    cause: { [`browDown${name}`]: 1, [`browDown${side > 0 ? 'Right' : 'Left'}`]: 0.5 },
    guides,
    spacing: 11,
    hidden: grown(age, 0.6, 1),
    deepest: grown(age, 1.1, 2.1),
    reach: 5,
    feather: 6,
    share: ([at]) => smoothstep((side * at + MIDDLE) / (2 * MIDDLE)),
  }
}

function noseRoot({ landmarks, age, random }: Build): Region {
  const numbers = random('noseRoot')
  const level = landmarks.eye[1] + 2
  const line = (up: number, half: number, width: number, depth: number): Guide => ({
    spots: bezier(1, [-half, up - 1.2], [-half / 3, up + 0.8], [half / 3, up + 0.8], [half, up - 1.2]),
    width,
    depth,
    taper: [0.45, 0.45],
    shoulder: [0.9, 0.9],
    softness: 0.5,
  })
  const guides = [line(level + numbers.sway(0.6), 9, grown(age, 2.8, 3.4), 1)]
  if (age > 0.35) guides.push(line(level - 4.6, 6.5, 2.4, 0.5))
  return {
    name: 'noseRoot',
    cause: { browDownLeft: 1, browDownRight: 1, noseSneerLeft: 0.5, noseSneerRight: 0.5 },
    guides,
    spacing: 9,
    hidden: grown(age, 0.3, 0.8),
    deepest: grown(age, 0.6, 1.1),
    reach: 4,
    feather: 5,
  }
}
