import { smoothstep } from '../../../math/scalar.ts'
import type { Spot } from '../chart.ts'
import { type Build, curve, type Guide, grown, type Region, SIDES, type Side, spotOf } from './region.ts'

/** Half the width in millimetres in which left and right, and inner and outer half, pass into one another. */
const MIDDLE = 4
const HALVES = 9

/**
 * The forehead: long lines across, one above the other, that dip between the brows and arch over them (frontalis). Four areas share
 * them, since its inner and outer parts rise apart.
 */
export function forehead({ landmarks, age, random }: Build): Region[] {
  const numbers = random('forehead')
  const inner = spotOf(landmarks.innerBrow)
  const outer = spotOf(landmarks.outerBrow)
  const brow = (inner[1] + outer[1]) / 2
  const height = landmarks.hairline - brow
  const lines = Math.round(grown(age, 4, 6))
  const guides: Guide[] = []
  for (let i = 0; i < lines; i++) {
    const share = (i + numbers.sway(0.12)) / (lines - 1)
    // The outermost lines are short and shallow.
    const strength = 1 - 0.5 * Math.abs(2 * share - 0.8) ** 1.5
    const reach = Math.abs(outer[0]) * (0.78 + 0.3 * strength) + numbers.sway(5)
    const level = brow + height * (0.2 + 0.58 * share)
    const sway = [numbers.sway(1.1), numbers.sway(1.1), numbers.next() * 6.28] as const
    const at = (across: number): Spot => {
      const dip = (3.2 - 2.2 * share) * Math.exp(-((across / 13) ** 2))
      const fall = (2.5 + 5.5 * share) * (Math.abs(across) / 50) ** 2.2
      const wave = sway[0] * Math.sin(across / 13 + sway[2]) + sway[1] * Math.sin(across / 7.3 - sway[2])
      return [across, level - dip - fall + wave]
    }
    const left = reach + numbers.sway(4)
    // Most lines are broken once: the pieces pass each other.
    const broken = numbers.next() < 0.65
    const gap = numbers.sway(0.75 * reach)
    const pieces = broken
      ? [
          [-left, gap + numbers.between(2, 5), numbers.between(-1.3, -0.6)],
          [gap - numbers.between(2, 5), reach, numbers.between(0.6, 1.3)],
        ]
      : [[-left, reach, 0]]
    for (const [from, to, lift] of pieces as [number, number, number][]) {
      const length = to - from
      guides.push({
        spots: curve(32, (t) => {
          const [across, up] = at(from + t * length)
          return [across, up + lift]
        }),
        width: grown(age, 3.6, 4.6) * (0.85 + 0.2 * strength),
        depth: strength * numbers.between(0.85, 1),
        taper: [Math.min(0.5, 16 / length), Math.min(0.5, 16 / length)],
        shoulder: [0.9, 0.9],
        softness: grown(age, 0.55, 0.4),
      })
    }
    if (i > 0 && numbers.next() < grown(age, 0.45, 0.9))
      guides.push(between(at, height / lines, reach, numbers.sway(0.6), age))
  }
  const region = (side: Side, sideName: string, half: 'Inner' | 'Outer'): Region => ({
    name: `forehead${half}${sideName}`,
    cause:
      half === 'Inner'
        ? { browInnerUp: 1, [`browOuterUp${sideName}`]: 0.5 }
        : { [`browOuterUp${sideName}`]: 1, browInnerUp: 0.4 },
    together: { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 },
    guides,
    spacing: height / lines,
    hidden: grown(age, 0.45, 0.9),
    deepest: grown(age, 0.8, 1.35),
    reach: 6,
    feather: 7,
    share: ([across]) => {
      const own = smoothstep((side * across + MIDDLE) / (2 * MIDDLE))
      const beyond = smoothstep((side * across - 0.42 * Math.abs(outer[0]) + HALVES) / (2 * HALVES))
      return own * (half === 'Outer' ? beyond : 1 - beyond)
    },
  })
  return SIDES.flatMap(([side, name]) => [region(side, name, 'Inner'), region(side, name, 'Outer')])
}

/** A short, faint line between two long ones. */
function between(
  at: (across: number) => Spot,
  spacing: number,
  reach: number,
  place: number,
  age: number,
): Guide {
  const middle = place * reach
  const half = 0.3 * reach
  return {
    spots: curve(16, (t) => {
      const [across, up] = at(middle + (2 * t - 1) * half)
      return [across, up - 0.5 * spacing]
    }),
    width: 2.4,
    depth: grown(age, 0.25, 0.42),
    taper: [0.5, 0.5],
    shoulder: [0.8, 0.8],
    softness: 0.6,
  }
}
