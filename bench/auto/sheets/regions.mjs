import { both } from '../../../scripts/figures/close-ups.mjs'

/** Width and height of a picture, pixels. */
export const TILE = 254

/**
 * Height of the pictures at 1 m, millimetres. On a screen with 1080 lines and a vertical field of view of 35 degrees, 254 lines show
 * this much of a face at 1 m.
 */
const AT_ONE_METRE = 148

/**
 * Columns of a sheet: the region without wrinkles, three ages close up, half of the expression, the face at 1 m, and the region from the angle
 * `side`.
 */
const COLUMNS = [
  { age: 50, mode: 'off' },
  { age: 30 },
  { age: 50 },
  { age: 70 },
  { age: 50, strength: 0.5 },
  { age: 50, isFar: true },
  { age: 50, side: true },
]

/**
 * Parts of the face that a sheet shows. `targets` is the expression that creases the region. `centre` returns the point in the middle of the
 * picture in face coordinates (see `Landmarks`). `height` returns the height of the visible part of the face there, in millimetres. `yaw` is
 * the camera's angle, in degrees, and `side` the angle for columns with `side: true`. Cameras on the person's left have positive angles.
 * Default columns: `COLUMNS`.
 */
export const REGIONS = {
  glabella: {
    targets: { ...both('browDown'), ...both('noseSneer', 0.2), ...both('eyeSquint', 0.3) },
    yaw: 10,
    side: 55,
    centre: ({ innerBrow: [, y, z] }) => [0, y + 2, z + 6],
    height: ({ innerBrow: [x], outerBrow }) => Math.max(58, 0.6 * (x + outerBrow[0])),
  },
  nose: {
    targets: { ...both('noseSneer'), ...both('mouthUpperUp', 0.4), ...both('browDown', 0.3) },
    yaw: 28,
    side: 65,
    centre: ({ innerCorner, tip }) => [6, 0.6 * innerCorner[1] + 0.4 * tip[1], tip[2] - 10],
    height: ({ innerCorner, noseBase }) => 1.25 * (innerCorner[1] - noseBase),
  },
  'crows-feet': {
    targets: { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.5) },
    yaw: 55,
    side: 20,
    centre: ({ outerCorner: [x, y, z] }) => [x + 10, y - 3, z - 8],
    height: () => 62,
  },
  'lower-lid': {
    targets: { ...both('eyeSquint'), ...both('cheekSquint', 0.9) },
    yaw: 22,
    side: 70,
    centre: ({ eye: [x, y, z] }) => [x, y - 9, z],
    height: ({ innerCorner, outerCorner }) => 1.5 * (outerCorner[0] - innerCorner[0]),
  },
  nasolabial: {
    targets: { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.6) },
    yaw: 30,
    side: 65,
    centre: ({ wing, mouthCorner }) => [
      Math.max(wing[0], mouthCorner[0]) + 2,
      (wing[1] + mouthCorner[1]) / 2 - 2,
      mouthCorner[2] + 4,
    ],
    height: ({ wing, mouthCorner }) => 40 + 1.3 * (wing[1] - mouthCorner[1]),
  },
  'mouth-corners': {
    targets: { ...both('mouthDimple', 0.9), ...both('mouthSmile', 0.4) },
    yaw: 32,
    side: 65,
    centre: ({ mouthCorner: [x, y, z], chin }) => [x + 4, 0.75 * y + 0.25 * chin, z + 2],
    height: ({ mouthCorner: [, y], chin }) => 1.5 * (y - chin),
  },
  lips: {
    targets: { mouthPucker: 1 },
    yaw: 12,
    side: 60,
    centre: ({ mouthCorner: [, y], tip }) => [0, y, tip[2] - 10],
    height: ({ mouthCorner: [x] }) => Math.max(42, 1.8 * x),
  },
  chin: {
    targets: { mouthShrugLower: 1, ...both('mouthPress', 0.3) },
    yaw: 12,
    side: 65,
    centre: ({ mouthCorner: [, y], chin, tip }) => [0, 0.25 * y + 0.75 * chin, tip[2] - 14],
    height: ({ mouthCorner: [, y], chin }) => 1.7 * (y - chin),
  },
  forehead: {
    targets: { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.5) },
    yaw: 15,
    side: 60,
    centre: ({ innerBrow, hairline }) => [0, 0.6 * innerBrow[1] + 0.4 * hairline, innerBrow[2]],
    height: ({ innerBrow, hairline }) => 1.6 * (hairline - innerBrow[1]),
  },
  neck: {
    targets: { jawOpen: 1 },
    yaw: 25,
    side: 70,
    centre: ({ chin, mouthCorner }) => [8, chin - 0.5 * (mouthCorner[1] - chin), -20],
    height: ({ mouthCorner, chin }) => 2.2 * (mouthCorner[1] - chin),
  },
  ageing: {
    targets: {},
    yaw: 30,
    side: 75,
    centre: ({ eye, tip }, yaw) => [(eye[0] + 2) * Math.min(1, yaw / 30), tip[1] + 6, 0],
    height: ({ hairline, chin }) => 0.92 * (hairline - chin),
    columns: [
      { age: 50, mode: 'off' },
      { age: 30 },
      { age: 50 },
      { age: 70 },
      { age: 50, yaw: 0 },
      { age: 70, yaw: 0 },
      { age: 70, side: true },
    ],
  },
}

/**
 * Returns requests for the pictures of a head, one per column. The caller adds the path of the head's file to each.
 *
 * @param frame result of `headFrame`.
 */
export function picturesOf(
  { targets, yaw, side, centre, height, columns = COLUMNS },
  { landmarks, scale, pointAt },
) {
  return columns.map((column) => {
    const { age, strength = 1, isFar = false, mode = 'default' } = column
    const shown = Object.fromEntries(
      Object.entries(targets).map(([name, weight]) => [name, strength * weight]),
    )
    const angle = column.side ? side : (column.yaw ?? yaw)
    const view = {
      yaw: angle,
      pitch: 2,
      point: pointAt(centre(landmarks, angle), shown),
      height: (isFar ? AT_ONE_METRE : height(landmarks)) / scale,
      // The lights follow the camera, so that the key light always grazes the skin from the upper left.
      light: angle,
    }
    return { age, picture: { width: TILE, height: TILE, relief: 'on', mode, targets: shown, view } }
  })
}
