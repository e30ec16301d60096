import type { Skin } from 'furrow/author'
import { CubicInterpolant, Vector3 } from 'three'
import { jointOf, PERSON, placeOf } from './person.ts'
import { trunkShares } from './torso.ts'
import { skinOf, type Tube, tube } from './tube.ts'

/** Half widths and depths of the dress by height, in metres, from the hem to the neckline. */
const SECTIONS = [
  [0.3, 0.33, 0.31],
  [0.5, 0.29, 0.27],
  [0.75, 0.235, 0.205],
  [0.95, 0.19, 0.15],
  [1.1, 0.145, 0.112],
  [1.25, 0.172, 0.13],
  [1.36, 0.19, 0.125],
  [1.41, 0.165, 0.1],
  [1.44, 0.1, 0.08],
] as const
/** Height below which legs move the dress, and the distance over which they take over, in metres. */
const [HIP, TAKEN] = [0.97, 0.14]
/** Width of the middle of the skirt, which both legs move. */
const BETWEEN = 0.26
const SLEEVE = 0.062
/** Length over which a joint takes over from the one before, metres. */
const BEND = 0.07
/** Part of the texture that the skirt and the bodice cover. The sleeves are above. */
const TRUNK_PART = 0.62

/**
 * Returns a dress with long sleeves, whose hem hangs below the knees, in metres. Skirt and bodice are one tube. In the texture it is unrolled:
 * u runs from the back over the person's left, the front and the right. The sleeves are two tubes, unrolled above it.
 */
export function dress(): Skin {
  return skinOf([trunk(), sleeve('Left'), sleeve('Right')], PERSON)
}

function trunk(): Tube {
  const [hem, neckline] = [SECTIONS[0][0], SECTIONS[SECTIONS.length - 1]![0]]
  return tube(72, 76, (s, t) => {
    const y = hem + s * (neckline - hem)
    const [wide, deep] = sections.evaluate(y) as unknown as [number, number]
    const angle = 2 * Math.PI * t
    const x = wide * Math.sin(angle)
    return {
      position: [x, y, -deep * Math.cos(angle)],
      uv: [0.02 + 0.96 * t, 0.02 + (TRUNK_PART - 0.04) * s],
      shares: sharesAt(x, y),
    }
  })
}

const sections = new CubicInterpolant(
  Float64Array.from(SECTIONS, ([height]) => height),
  Float64Array.from(SECTIONS.flatMap(([, wide, deep]) => [wide, deep])),
  2,
)

const step = (value: number) =>
  Math.min(1, Math.max(0, value)) ** 2 * (3 - 2 * Math.min(1, Math.max(0, value)))

function sharesAt(x: number, y: number): [joint: number, weight: number][] {
  const legs = step((HIP - y) / TAKEN)
  if (legs === 0) return trunkShares(y)
  const left = step(x / BETWEEN + 0.5)
  const lower = step((placeOf('LeftLeg').y - y) / 0.16 + 0.5)
  const own = trunkShares(y).map(([joint, weight]) => [joint, weight * (1 - legs)] as [number, number])
  const ofLegs = (['Left', 'Right'] as const).flatMap((side): [number, number][] => {
    const share = legs * (side === 'Left' ? left : 1 - left)
    return [
      [jointOf(`${side}UpLeg`), share * (1 - lower)],
      [jointOf(`${side}Leg`), share * lower],
    ]
  })
  const largest = [...own, ...ofLegs].sort((a, b) => b[1] - a[1]).slice(0, 4)
  const sum = largest.reduce((total, [, weight]) => total + weight, 0)
  return largest.map(([joint, weight]) => [joint, weight / sum])
}

function sleeve(side: 'Left' | 'Right'): Tube {
  const [shoulder, elbow, wrist] = ['Arm', 'ForeArm', 'Hand'].map((name) => placeOf(`${side}${name}`)) as [
    Vector3,
    Vector3,
    Vector3,
  ]
  const direction = wrist.clone().sub(shoulder)
  const length = direction.length()
  direction.normalize()
  const across = new Vector3(0, 0, 1).cross(direction).normalize()
  const front = direction.clone().cross(across)
  const hinge = elbow.distanceTo(shoulder)
  const start = -0.05
  return tube(32, 56, (s, t) => {
    const along = start + s * (length - start)
    const angle = 2 * Math.PI * t
    // The sleeve ends in a dome over the shoulder.
    const radius = SLEEVE * (1.12 - 0.32 * s) * Math.sin((Math.PI / 2) * Math.min(1, s / 0.15)) ** 0.5
    const position = shoulder
      .clone()
      .addScaledVector(direction, along)
      .addScaledVector(across, radius * Math.cos(angle))
      .addScaledVector(front, radius * Math.sin(angle))
    const upper = step((along - 0.02) / (2 * BEND) + 0.5)
    const lower = step((along - hinge) / BEND + 0.5)
    const shares: [number, number][] = [
      [jointOf('Spine2'), 1 - upper],
      [jointOf(`${side}Arm`), upper - lower],
      [jointOf(`${side}ForeArm`), lower],
    ]
    const column = side === 'Left' ? 0 : 0.5
    return {
      position: position.toArray(),
      uv: [column + 0.02 + 0.46 * s, TRUNK_PART + 0.02 + (0.96 - TRUNK_PART) * t],
      shares,
    }
  })
}
