import { both } from './close-ups.mjs'

const SIZE = { width: 1600, height: 1200 }
/** Crop at full resolution: 55 pixels per degree, about what an eye resolves at that distance. */
const SHOWN = { width: 270, height: 250 }

/**
 * Camera distances of 40 cm (the cheek below the left eye), 1 m (a quarter of the face) and 3 m (the head), and crop origins.
 * The head fills the frame at 82 cm.
 */
const DISTANCES = [
  { zoom: 2.05, left: 620, top: 590 },
  { zoom: 0.78, left: 620, top: 450 },
  { zoom: 0.268, left: 668, top: 444 },
]

/** At rest; with the skin around the eye compressed; with the same skin and the cheek stretched. */
const POSES = [
  {},
  { ...both('cheekSquint', 0.9), ...both('eyeSquint', 0.4), ...both('mouthSmile', 0.7) },
  { browInnerUp: 0.8, ...both('browOuterUp'), ...both('eyeWide', 0.5), jawOpen: 0.9 },
]

/** Fine furrows: one row per pose, one column per distance. */
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
