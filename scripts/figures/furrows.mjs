import { both } from './close-ups.mjs'

const SIZE = { width: 1600, height: 1200 }
/** Pixels as they are drawn, so that the figure shows what an eye at that distance can tell apart: 55 are a degree. */
const SHOWN = { width: 270, height: 250 }

/**
 * Distances of the camera from the shipped face, whose head fills the stage's lens from 82 cm, and where the shown part begins: 40 cm, the
 * cheek below the left eye; 1 m, a quarter of the face; 3 m, the head.
 */
const DISTANCES = [
  { zoom: 2.05, left: 620, top: 590 },
  { zoom: 0.78, left: 620, top: 450 },
  { zoom: 0.268, left: 668, top: 444 },
]

/** At rest; the skin round the eye squeezed; the same skin and the cheek pulled. */
const POSES = [
  {},
  { ...both('cheekSquint', 0.9), ...both('eyeSquint', 0.4), ...both('mouthSmile', 0.7) },
  { browInnerUp: 0.8, ...both('browOuterUp'), ...both('eyeWide', 0.5), jawOpen: 0.9 },
]

/** Fine furrows: a row for each pose, a column for each distance. */
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
