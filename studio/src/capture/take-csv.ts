import { canonicalTargetName } from 'furrow/internal'
import { framesOf, TAKE_RATE, type Take, trimmed, weightsOf } from '../document/take.ts'

const bothSides = (name: string) => [`${name}Left`, `${name}Right`]
const ofEye = (side: string) =>
  ['Blink', 'LookDown', 'LookIn', 'LookOut', 'LookUp', 'Squint', 'Wide'].map((name) => `Eye${name}${side}`)

/** Blendshapes in the order of the app Live Link Face. */
const SHAPES = [
  ...ofEye('Left'),
  ...ofEye('Right'),
  ...['JawForward', 'JawRight', 'JawLeft', 'JawOpen'],
  ...['MouthClose', 'MouthFunnel', 'MouthPucker', 'MouthRight', 'MouthLeft'],
  ...['MouthSmile', 'MouthFrown', 'MouthDimple', 'MouthStretch'].flatMap(bothSides),
  ...['MouthRollLower', 'MouthRollUpper', 'MouthShrugLower', 'MouthShrugUpper'],
  ...['MouthPress', 'MouthLowerDown', 'MouthUpperUp', 'BrowDown'].flatMap(bothSides),
  'BrowInnerUp',
  ...bothSides('BrowOuterUp'),
  'CheekPuff',
  ...['CheekSquint', 'NoseSneer'].flatMap(bothSides),
  'TongueOut',
]
const ROTATIONS = ['Head', 'LeftEye', 'RightEye'].flatMap((part) =>
  ['Yaw', 'Pitch', 'Roll'].map((axis) => `${part}${axis}`),
)

/**
 * Writes a take as the CSV of the app Live Link Face, at 60 frames per second. The columns are all 52 blendshapes of ARKit, rotations, which
 * are 0, and the other blendshapes of the take. Writes only key frames between the in and out points.
 *
 * @returns lines with their line ends.
 */
export function takeCsv(take: Take): string[] {
  const motion = trimmed(take)
  const frames = framesOf(motion)
  const own = new Map(motion.names.map((name, i) => [canonicalTargetName(name), weightsOf(motion, i)]))
  const columns = SHAPES.map((name) => takeColumn(own, name[0].toLowerCase() + name.slice(1)))
  const header = [
    'Timecode',
    'BlendShapeCount',
    ...SHAPES,
    ...ROTATIONS,
    ...[...own.keys()].map((name) => name.replace(/[,;"\s]/g, '_')),
  ]
  const rotations = ROTATIONS.map(() => 0)
  const lines = [header.join()]
  for (let frame = 0; frame < frames; frame++) {
    const weights = [...columns, ...own.values()].map((column) => weightText(column?.[frame] ?? 0))
    weights.splice(SHAPES.length, 0, ...rotations.map(String))
    lines.push([timecode(frame), SHAPES.length + ROTATIONS.length, ...weights].join())
  }
  return lines.map((line) => `${line}\r\n`)
}

/** Removes a blendshape from the map and returns its weights. If only its halves exist, returns their mean. */
function takeColumn(own: Map<string, Float32Array>, name: string): Float32Array | undefined {
  const whole = own.get(name)
  own.delete(name)
  if (whole) return whole
  const halves = bothSides(name).flatMap((half) => own.get(half) ?? [])
  for (const half of bothSides(name)) own.delete(half)
  if (halves.length < 2) return halves[0]
  return halves[0].map((weight, i) => (weight + halves[1][i]) / 2)
}

function weightText(weight: number): string {
  return `${Number(weight.toFixed(5))}`
}

/** Time of a key frame as `HH:MM:SS:FF`. */
function timecode(frame: number): string {
  const seconds = Math.floor(frame / TAKE_RATE)
  const parts = [seconds / 3600, (seconds / 60) % 60, seconds % 60, frame % TAKE_RATE]
  return parts.map((part) => `${Math.floor(part)}`.padStart(2, '0')).join(':')
}
