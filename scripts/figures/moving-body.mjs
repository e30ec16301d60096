const FRAME = { width: 560, height: 760, crop: { left: 70, top: 30, width: 420, height: 600 }, scale: 0.8 }
const AT_TRUNK = 'zoom=1.35&height=0.12&across=0.03&view=-14'
/** Clips of `faces/body.glb`: times in seconds, where the camera looks, and whether the clip goes back the way it came. */
const CLIPS = [
  { name: 'bend', times: range(0, 1.2, 7), camera: AT_TRUNK, returns: true },
  { name: 'turn', times: range(0, 1.2, 7), camera: AT_TRUNK, returns: true },
  { name: 'walk', times: range(0, 1.1, 12), camera: 'zoom=1&height=-0.02&view=-50', returns: false },
]
/** Number of strides. */
const STRIDES = 3
/** Durations of the frames, milliseconds. */
const DELAY = { moving: 100, full: 900 }

/** Returns all pictures without folds, then all pictures with folds. */
export function movingBodyPictures() {
  return ['&smooth', ''].flatMap((end) =>
    CLIPS.flatMap(({ name, times, camera }) =>
      times.map((time) => ({
        ...FRAME,
        page: `clothes.html?clip=${name}&time=0&${camera}${end}`,
        sliders: { 'stop at second': time },
      })),
    ),
  )
}

/** Returns the frames of the animation, see `movingFrames`. */
export function movingBodyFrames() {
  const count = CLIPS.reduce((sum, { times }) => sum + times.length, 0)
  const frame = (picture, delay) => ({ pictures: [picture, picture + count], delay })
  let first = 0
  return CLIPS.flatMap(({ times, returns }) => {
    const moving = times.map((_, i) => frame(first + i, DELAY.moving))
    first += times.length
    if (!returns) return Array.from({ length: STRIDES }, () => moving).flat()
    const full = { ...moving.at(-1), delay: DELAY.full }
    return [...moving.slice(0, -1), full, ...moving.slice(0, -1).toReversed()]
  })
}

/** Returns numbers at equal distances. */
function range(from, to, count) {
  return Array.from({ length: count }, (_, i) => Number((from + (i * (to - from)) / (count - 1)).toFixed(3)))
}
