import { both } from './close-ups.mjs'

const SIZE = { width: 1600, height: 1200 }
/**
 * Size of the crop at full resolution, pixels. At the nearest distance, one degree of the view covers 55 pixels, which
 * is about the resolution of the human eye.
 */
const SHOWN = { width: 270, height: 250 }

/**
 * Cameras and the top left corners of their crops. From 40 cm, the crop shows the cheek below the left eye, from 1 m a
 * quarter of the face, from 3 m the head. At `zoom` 1 the distance is 82 cm, and the head fills the uncropped picture.
 */
const DISTANCES = [
  { zoom: 2.05, left: 620, top: 590 },
  { zoom: 0.78, left: 620, top: 450 },
  { zoom: 0.268, left: 668, top: 444 },
]

/**
 * Three poses: at rest, with compressed skin around the eye, and with stretched skin around the eye and on the cheek.
 */
const POSES = [
  {},
  { ...both('cheekSquint', 0.9), ...both('eyeSquint', 0.4), ...both('mouthSmile', 0.7) },
  { browInnerUp: 0.8, ...both('browOuterUp'), ...both('eyeWide', 0.5), jawOpen: 0.9 },
]

/** Pictures of fine skin furrows, one row per pose and one column per distance. */
export const FURROWS = POSES.flatMap((targets) =>
  DISTANCES.map(({ zoom, left, top }, i) => ({
    ...SIZE,
    targets,
    face: 'furrows',
    relief: 'on',
    view: { yaw: 38, pitch: 2, zoom },
    crop: { ...SHOWN, left, top },
    beginsRow: i === 0,
  })),
)
