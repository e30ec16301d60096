import { both } from './close-ups.mjs'

const FRAME = {
  width: 720,
  height: 840,
  view: { yaw: 16, pitch: 2, zoom: 1.08 },
  crop: { left: 144, top: 170, width: 432, height: 576 },
}
const EXPRESSIONS = [
  { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.6), jawOpen: 0.15 },
  { ...both('browDown'), ...both('noseSneer', 0.8), ...both('eyeSquint', 0.4), ...both('mouthUpperUp', 0.2) },
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3), jawOpen: 0.05 },
]
/** Number of pictures per expression, from the neutral face to the full expression. */
const STEPS = 8
/** Durations of the frames, milliseconds. */
const DELAY = { moving: 60, full: 900, rest: 400 }

/** Returns all pictures without wrinkles, then all pictures with wrinkles. */
export function movingPictures() {
  const poses = EXPRESSIONS.flatMap((targets) =>
    Array.from({ length: STEPS }, (_, i) => scaled(targets, ease((i + 1) / STEPS))),
  )
  const both = [{}, ...poses].map((targets) => ({ ...FRAME, targets }))
  return [
    ...both.map((picture) => ({ ...picture, mode: 'off' })),
    ...both.map((picture) => ({ ...picture, relief: 'on' })),
  ]
}

/**
 * Returns the frames of the animation. Each has the indices of two pictures that it shows side by side, and its
 * duration in milliseconds.
 */
export function movingFrames() {
  const count = 1 + EXPRESSIONS.length * STEPS
  const frame = (picture, delay) => ({ pictures: [picture, picture + count], delay })
  return EXPRESSIONS.flatMap((_, e) => {
    const first = 1 + e * STEPS
    const rising = Array.from({ length: STEPS - 1 }, (_, i) => frame(first + i, DELAY.moving))
    return [frame(0, DELAY.rest), ...rising, frame(first + STEPS - 1, DELAY.full), ...rising.toReversed()]
  })
}

const ease = (t) => t * t * (3 - 2 * t)

function scaled(targets, factor) {
  return Object.fromEntries(Object.entries(targets).map(([name, weight]) => [name, weight * factor]))
}
