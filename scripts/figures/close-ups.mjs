import { AGES, BEFORE } from './faces.mjs'

export const both = (name, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })

/** Rendered size, pixels. The figures show a crop of size `SHOWN`. */
const SIZE = { width: 1600, height: 1200 }
const VIEWS = {
  profile: { yaw: 90, pitch: 2, zoom: 1.9 },
  'three-quarter': { yaw: 38, pitch: 2, zoom: 1.9 },
}
const SHOWN = { width: 880, height: 1100 }

/** Top left corner of the crop per face, pixels: `top` for all views, and `left` per view. */
const FACES = {
  human: { top: 100, left: { profile: 60, 'three-quarter': 230 } },
  'human-2': { top: 100, left: { profile: 60, 'three-quarter': 230 } },
  scan: { mesh: 'face', top: 40, left: { profile: 160, 'three-quarter': 330 } },
}

const EXPRESSIONS = [
  { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.6) },
  { ...both('browDown'), ...both('noseSneer', 0.3), ...both('eyeSquint', 0.4) },
  { ...both('noseSneer'), ...both('mouthUpperUp', 0.4), ...both('browDown', 0.3) },
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) },
]

/**
 * Returns the pictures of a face in one view, one row per expression. A row shows the face at each age. If there is an earlier
 * version, its result at 70 years comes first.
 */
function closeUps(name, view) {
  const { mesh, top, left } = FACES[name]
  const columns = [
    ...(BEFORE ? [{ face: `${name}Before` }] : []),
    ...AGES.map((age) => ({ face: `${name}${age}`, relief: 'on' })),
  ]
  return EXPRESSIONS.flatMap((targets) =>
    columns.map((column, i) => ({
      ...SIZE,
      ...column,
      ...(mesh && { mesh }),
      view: VIEWS[view],
      targets,
      crop: { ...SHOWN, left: left[view], top },
      scale: 0.55,
      beginsRow: i === 0,
    })),
  )
}

export const CLOSE_UPS = Object.fromEntries(
  Object.keys(FACES).flatMap((name) =>
    Object.keys(VIEWS).map((view) => [`skin/${name}-${view}`, closeUps(name, view)]),
  ),
)
