import { finiteOrNull, type LiveSource, type Scores } from './source.ts'

/** Features in the order of the packet. Each is -1..1 and 0 at rest. */
const NAMES = [
  'EyeLeft',
  'EyeRight',
  ...['Left', 'Right'].flatMap((side) => [
    `EyebrowSteepness${side}`,
    `EyebrowUpDown${side}`,
    `EyebrowQuirk${side}`,
  ]),
  ...['Left', 'Right'].flatMap((side) => [`MouthCornerUpDown${side}`, `MouthCornerInOut${side}`]),
  'MouthOpen',
  'MouthWide',
]

/** Byte that tells whether the points of the face were found. It follows time, number of the face, resolution and eyes. */
const FOUND = 8 + 4 + 2 * 4 + 2 * 4

/** Offset of the features, after the fit error, the pose, and confidences and positions of 68 points in 2D and 70 in 3D. */
const FEATURES = FOUND + 1 + 4 + 4 * 4 + 3 * 4 + 3 * 4 + 4 * 68 + 4 * 2 * 68 + 4 * 3 * 70

/** Size of a face in the packet. */
const FACE = FEATURES + 4 * NAMES.length

/**
 * OpenSeeFace, a tracker for webcams. Layout, little-endian, per face: see the constants above. Only the first face is read.
 * Source: `Unity/OpenSee.cs` of https://github.com/emilianavt/OpenSeeFace, commit bc74658.
 */
export const OPEN_SEE_FACE: LiveSource = { port: 11573, createReader: () => readPacket }

function readPacket(packet: Uint8Array): Scores | null {
  if (packet.byteLength === 0 || packet.byteLength % FACE !== 0 || packet[FOUND] === 0) return null
  const view = new DataView(packet.buffer, packet.byteOffset, FACE)
  return finiteOrNull(
    Object.fromEntries(NAMES.map((name, i) => [name, view.getFloat32(FEATURES + 4 * i, true)])),
  )
}
