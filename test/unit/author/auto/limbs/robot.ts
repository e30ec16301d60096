import type { Skin } from 'furrow/author'
import { Vector3 } from 'three'
import { jointOf, PERSON, placeOf } from './person.ts'
import { FINGERS } from './rigs.ts'
import { skinOf, type Tube, tube } from './tube.ts'

const [AROUND, ALONG] = [20, 16]
/** Gap between two parts as a fraction of a part. */
const GAP = 0.01
/** Parts: the joint that moves the part, the joint at which it ends, and its radius in metres. */
const LIMBS = [
  ['Arm', 'ForeArm', 0.045],
  ['ForeArm', 'Hand', 0.038],
  ['Hand', 'HandMiddle1', 0.034],
  ['UpLeg', 'Leg', 0.07],
  ['Leg', 'Foot', 0.05],
  ['Foot', 'ToeBase', 0.04],
] as const
const TRUNK = [
  ['Hips', [0, 0.93, 0], [0, 1.08, 0], 0.105],
  ['Spine', [0, 1.08, 0], [0, 1.23, 0], 0.09],
  ['Spine2', [0, 1.23, 0], [0, 1.41, 0], 0.105],
  ['Neck', [0, 1.43, 0], [0, 1.56, 0], 0.045],
  ['Head', [0, 1.54, 0.01], [0, 1.78, 0.01], 0.095],
] as const
const FINGER_RADIUS = 0.0085

/** Returns a robot of hard parts in metres. One joint moves each part. */
export function robot(): Skin {
  const limbs = ['Left', 'Right'].flatMap((side) => [
    ...LIMBS.map(([own, end, radius]) => [`${side}${own}`, placeOf(`${side}${end}`), radius] as const),
    ...FINGERS.flatMap((finger) => fingerOf(`${side}Hand${finger === 'little' ? 'Pinky' : title(finger)}`)),
  ])
  const parts = [
    ...TRUNK.map(([name, from, to, radius]) => ({
      name,
      from: new Vector3(...from),
      to: new Vector3(...to),
      radius,
    })),
    ...limbs.map(([name, to, radius]) => ({ name, from: placeOf(name), to, radius })),
  ]
  const columns = Math.ceil(Math.sqrt(parts.length))
  return skinOf(
    parts.map((part, i) => shell(part, [i % columns, Math.floor(i / columns)], columns)),
    PERSON,
  )
}

const title = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

function fingerOf(name: string): [name: string, end: Vector3, radius: number][] {
  const places = [1, 2, 3].map((k) => placeOf(`${name}${k}`))
  const tip = places[2]!.clone().multiplyScalar(2).sub(places[1]!)
  return [...places.slice(1), tip].map((end, k) => [`${name}${k + 1}`, end, FINGER_RADIUS])
}

/** Returns a closed spindle, unrolled into one cell of the texture. */
function shell(
  { name, from, to, radius }: { name: string; from: Vector3; to: Vector3; radius: number },
  [column, row]: readonly [number, number],
  columns: number,
): Tube {
  const direction = to.clone().sub(from)
  const across = new Vector3(0, 0, 1).cross(direction).normalize()
  const front = direction.clone().cross(across).normalize()
  const joint = jointOf(name)
  return tube(AROUND, ALONG, (s, t) => {
    const along = GAP + (1 - 2 * GAP) * s
    const angle = 2 * Math.PI * t
    // The ends are closed and round.
    const own = radius * Math.sin(Math.PI * s) ** 0.25
    const position = from
      .clone()
      .addScaledVector(direction, along)
      .addScaledVector(across, own * Math.cos(angle))
      .addScaledVector(front, own * Math.sin(angle))
    return {
      position: position.toArray(),
      uv: [(column + 0.05 + 0.9 * t) / columns, (row + 0.05 + 0.9 * s) / columns],
      shares: [[joint, 1]],
    }
  })
}
