import { type Build, bezier, type Guide, grown, type Region, SIDES, type Side, spotOf } from './region.ts'

/** The sides of the nose: short lines that run outwards from its ridge (nasalis). */
export function nose(build: Build): Region[] {
  return SIDES.map(([side, name]) => bunnyLines(build, side, name))
}

function bunnyLines({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`nose${name}`)
  const [corner] = spotOf(landmarks.innerCorner)
  const eye = landmarks.eye[1]
  const lines = Math.round(grown(age, 3, 4))
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const up = eye - 9 - 4.9 * i + numbers.sway(0.5)
    const end = corner * (0.8 + 0.13 * i) + numbers.sway(0.8)
    const rise = 3 - 1.2 * i + numbers.sway(0.5)
    return {
      spots: bezier(
        side,
        [1.6 + 0.8 * i, up],
        [4 + i, up + 0.4],
        [end - 4, up + 0.5 * rise],
        [end, up + rise],
      ),
      width: grown(age, 2.4, 3),
      depth: i === 0 ? 0.75 : 1 - 0.12 * i,
      taper: [0.45, 0.5],
      shoulder: [0.9, 0.9],
      softness: 0.5,
    }
  })
  return {
    name: `nose${name}`,
    cause: { [`noseSneer${name}`]: 1 },
    guides,
    spacing: 4.5,
    hidden: grown(age, 0.35, 0.8),
    deepest: grown(age, 0.5, 0.9),
    reach: 3,
    feather: 5,
  }
}
