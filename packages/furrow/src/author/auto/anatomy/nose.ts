import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  SIDES,
  type Side,
} from './region.ts'

/** Returns the regions on both sides of the nose: short lines that run outwards from the ridge (nasalis muscle). */
export function nose(context: FaceContext): FaceRegion[] {
  return SIDES.map(([side, name]) => bunnyLines(context, side, name))
}

function bunnyLines({ landmarks, byAge, rngOf }: FaceContext, side: Side, name: string): FaceRegion {
  const rng = rngOf(`nose${name}`)
  const [corner] = chartPointOf(landmarks.innerCorner)
  const eye = landmarks.eye[1]
  const lines = Math.round(byAge(3, 4))
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const up = eye - 9 - 4.9 * i + rng.jitter(0.5)
    const end = corner * (0.8 + 0.13 * i) + rng.jitter(0.8)
    const rise = 3 - 1.2 * i + rng.jitter(0.5)
    return {
      path: bezierPath(
        side,
        [1.6 + 0.8 * i, up],
        [4 + i, up + 0.4],
        [end - 4, up + 0.5 * rise],
        [end, up + rise],
      ),
      width: byAge(2, 2.5),
      depth: i === 0 ? 0.75 : 1 - 0.12 * i,
      taper: [0.45, 0.5],
      shoulder: [0.9, 0.9],
      softness: 0.65,
    }
  })
  return {
    name: `nose${name}`,
    cause: { [`noseSneer${name}`]: 1 },
    guides,
    spacing: 4.5,
    creasedFraction: byAge(0.35, 0.8),
    maxDepth: byAge(0.5, 0.9),
    atRest: 0.15,
    reach: 3,
    feather: 5,
  }
}
