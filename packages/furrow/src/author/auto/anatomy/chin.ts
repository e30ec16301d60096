import { cos, sin } from '../../../math/elementary.ts'
import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Guide } from './region.ts'

/** Returns the regions of the chin and the neck: chin dimples, the crease above the chin (mentalis muscle), and neck rings. */
export function chinAndNeck(context: FaceContext): FaceRegion[] {
  return [chin(context), neck(context)]
}

function chin({ landmarks, byAge, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('chin')
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const half = 0.55 * corner
  const above = mouth - 0.34 * (mouth - landmarks.chin)
  const guides: Guide[] = [
    {
      path: bezierPath(
        1,
        [-half, above - 2.5],
        [-half / 2, above + 1.5],
        [half / 2, above + 1.5],
        [half, above - 2.5],
      ),
      width: byAge(5, 6),
      depth: 1,
      taper: [0.5, 0.5],
      shoulder: [0.6, 0.9],
      softness: 0.6,
    },
  ]
  const middle = 0.5 * (above + landmarks.chin) + 2
  // The golden angle keeps dimples apart (H. Vogel 1979, A better way to construct the sunflower head).
  for (let i = 0; i < 22; i++) {
    const angle = 2.4 * i + rng.jitter(0.3)
    const radius = Math.sqrt((i + 0.5) / 22)
    const [x, y] = [radius * 0.62 * corner * cos(angle), middle + radius * 9.5 * sin(angle)]
    const direction = rng.uniform(0, Math.PI)
    const halfLength = rng.uniform(0.8, 1.6)
    const [dx, dy] = [halfLength * cos(direction), halfLength * sin(direction)]
    guides.push({
      path: bezierPath(
        1,
        [x - dx, y - dy],
        [x - dx / 3, y - dy / 3],
        [x + dx / 3, y + dy / 3],
        [x + dx, y + dy],
      ),
      width: rng.uniform(2.6, 3.6),
      depth: rng.uniform(0.3, 0.55) * (1.15 - radius),
      taper: [0.3, 0.3],
      shoulder: [0.9, 0.9],
      softness: 0.9,
      isDimple: true,
    })
  }
  return {
    name: 'chin',
    cause: { mouthShrugLower: 1, mouthFrownLeft: 0.3, mouthFrownRight: 0.3 },
    guides,
    spacing: 7,
    creasedFraction: byAge(0.3, 0.7),
    maxDepth: byAge(0.6, 1),
    atRest: 0.2,
    assumedCompression: 0.1,
    reach: 3,
    feather: 5,
  }
}

function neck({ landmarks, byAge, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('neck')
  const rings = Math.round(byAge(2, 3))
  const guides = Array.from({ length: rings }, (_, i): Guide => {
    const up = landmarks.chin - 34 - 17 * i + rng.jitter(2)
    const half = 46 + rng.jitter(6)
    return {
      path: bezierPath(
        1,
        [-half, up + 7],
        [-half / 3, up - 2],
        [half / 3, up - 2 + rng.jitter(1)],
        [half, up + 7],
      ),
      width: byAge(3, 4),
      depth: rng.uniform(0.7, 1),
      taper: [0.5, 0.5],
      shoulder: [0.3, 0.3],
      softness: 0.6,
    }
  })
  return {
    name: 'neck',
    cause: { jawOpen: 1 },
    guides,
    spacing: 17,
    creasedFraction: byAge(0.15, 0.5),
    maxDepth: byAge(0.3, 0.9),
    atRest: 0.5,
    reach: 6,
    feather: 8,
  }
}
