import { finiteOrNull, type LiveSource, type Scores } from './source.ts'

/** Blendshapes in the order of the packet. Nine rotations of head and eyes follow, which are ignored. */
const NAMES = [
  ...eyeNames('Left'),
  ...eyeNames('Right'),
  ...['jawForward', 'jawLeft', 'jawRight', 'jawOpen'],
  ...['mouthClose', 'mouthFunnel', 'mouthPucker', 'mouthLeft', 'mouthRight'],
  ...['mouthSmile', 'mouthFrown', 'mouthDimple', 'mouthStretch'].flatMap(bothSides),
  ...['mouthRollLower', 'mouthRollUpper', 'mouthShrugLower', 'mouthShrugUpper'],
  ...['mouthPress', 'mouthLowerDown', 'mouthUpperUp', 'browDown'].flatMap(bothSides),
  'browInnerUp',
  ...bothSides('browOuterUp'),
  'cheekPuff',
  ...['cheekSquint', 'noseSneer'].flatMap(bothSides),
  'tongueOut',
]

/** Number of the packet format. */
const VERSION = 6

/** Maximum length of the names of device and subject, bytes. */
const MAX_TEXT = 256

/** Size of frame number, fraction of a frame, and frame rate as a fraction, bytes. */
const FRAME_TIME = 16

/**
 * Live Link Face of Epic Games, for iPhones. Layout, big-endian: version (uint8), name of the device and of the subject (int32 length and
 * UTF-8 each), time of the frame (16 bytes), number of values (uint8), values (float32).
 * Source: `pylivelinkface.py` of https://github.com/JimWest/PyLiveLinkFace, commit 28804bd.
 */
export const LIVE_LINK_FACE: LiveSource = { port: 11111, createReader: () => readPacket }

function readPacket(packet: Uint8Array): Scores | null {
  const view = new DataView(packet.buffer, packet.byteOffset, packet.byteLength)
  if (view.byteLength < 1 || view.getUint8(0) !== VERSION) return null
  const device = endOfText(view, 1)
  const subject = device === null ? null : endOfText(view, device)
  if (subject === null || view.byteLength < subject + FRAME_TIME + 1) return null
  const count = view.getUint8(subject + FRAME_TIME)
  const start = subject + FRAME_TIME + 1
  if (count < NAMES.length || view.byteLength !== start + 4 * count) return null
  return finiteOrNull(Object.fromEntries(NAMES.map((name, i) => [name, view.getFloat32(start + 4 * i)])))
}

/** Returns the offset after a text, or null if the text is longer than the packet. */
function endOfText(view: DataView, offset: number): number | null {
  if (view.byteLength < offset + 4) return null
  const length = view.getInt32(offset)
  const end = offset + 4 + length
  return length >= 0 && length <= MAX_TEXT && end <= view.byteLength ? end : null
}

function bothSides(name: string): string[] {
  return [`${name}Left`, `${name}Right`]
}

function eyeNames(side: string): string[] {
  return ['Blink', 'LookDown', 'LookIn', 'LookOut', 'LookUp', 'Squint', 'Wide'].map(
    (name) => `eye${name}${side}`,
  )
}
