import { Vector3 } from 'three'

/** Width and height of a picture, pixels. */
export const TILE = 300

const [FRONT, BACK, UP, LEFT] = [
  [0, 0, 1],
  [0, 0, -1],
  [0, 1, 0],
  [1, 0, 0],
].map((direction) => new Vector3(...direction))

/**
 * Columns of a sheet: share of the angles `bent` and `more` of a region, and whether the camera is at the angle `side`.
 */
const COLUMNS = [
  { degrees: () => 0 },
  { degrees: ({ bent }) => bent },
  { degrees: ({ more }) => more },
  { degrees: ({ more }) => more, isProfile: true },
]

/**
 * Rows of a sheet: parts of the body that joints fold. All are on the person's left. `bent` and `more` are angles in degrees. `turns` returns
 * the joints that turn, with their axes. `view` returns the point in the middle of the picture and the height of the visible part. `yaw` and
 * `pitch` are the angles of the camera in degrees, and `side` its yaw in profile. Cameras on the person's left have positive yaws.
 */
export const REGIONS = {
  elbow: {
    bent: 40,
    more: 85,
    turns: (frame) => hingeTurns(frame, 'elbow', FRONT),
    view: (frame) => atHinge(frame, 'elbow', 1.25),
    yaw: 45,
    side: 100,
  },
  knee: {
    bent: 50,
    more: 100,
    turns: (frame) => hingeTurns(frame, 'knee', BACK),
    view: (frame) => atHinge(frame, 'knee', 1.1),
    yaw: 55,
    side: 110,
  },
  hip: {
    bent: 40,
    more: 85,
    turns: (frame) => startTurns(frame, 'knee', FRONT),
    view: (frame) => atStart(frame, 'knee', 1.35),
    yaw: 35,
    side: 90,
  },
  waist: {
    bent: 25,
    more: 55,
    turns: ({ trunk }) => [{ joints: trunk.chain, axis: LEFT }],
    view: atTrunk,
    yaw: 30,
    side: 85,
  },
  twist: {
    bent: 22,
    more: 45,
    turns: ({ trunk }) => [{ joints: trunk.chain, axis: UP }],
    view: atTrunk,
    yaw: 10,
    side: 80,
  },
  shoulder: {
    bent: 40,
    more: 80,
    turns: (frame) => startTurns(frame, 'elbow', UP),
    view: (frame) => atStart(frame, 'elbow', 1.5),
    yaw: 15,
    side: 70,
  },
  neck: {
    bent: 35,
    more: 65,
    turns: ({ neck }) => [{ joints: neck.chain, axis: UP }],
    view: ({ neck, placeOf }) => {
      const [base, head] = [neck.chain[0], neck.chain.at(-1)].map(placeOf)
      return { point: base.clone().lerp(head, 0.4), height: 2.4 * base.distanceTo(head) }
    },
    yaw: 15,
    side: 75,
  },
  fist: {
    bent: 40,
    more: 80,
    turns: fistTurns,
    view: (frame) => {
      const { wrist, fingers } = leftHand(frame)
      const [start, knuckle] = [wrist, fingers.get('middle')[0]].map(frame.placeOf)
      return { point: start.clone().lerp(knuckle, 0.9), height: 2.4 * start.distanceTo(knuckle) }
    },
    yaw: 20,
    pitch: -30,
    side: 110,
  },
}

/**
 * Returns requests for the pictures of a region, one per column. The caller adds the file and the mesh to each.
 *
 * @param frame result of `bodyFrame`.
 */
export function picturesOf({ turns, view, yaw, side, pitch = 4, ...region }, frame) {
  const { point, height } = view(frame)
  return COLUMNS.map(({ degrees, isProfile }) => {
    const angle = isProfile ? side : yaw
    return {
      width: TILE,
      height: TILE,
      joints: frame.pose(turns(frame), degrees(region)),
      // The lights follow the camera, so that the key light always grazes the surface from the upper left.
      view: { yaw: angle, pitch, point: point.toArray(), height, light: angle },
    }
  })
}

const isLeft = ({ placeOf }, joint) => placeOf(joint).x > 0

function limbOf(frame, kind) {
  return frame.limbs.find((limb) => limb.kind === kind && isLeft(frame, limb.hinge))
}

function leftHand(frame) {
  return frame.hands.find(({ wrist }) => isLeft(frame, wrist))
}

/** Turns the lower half of a limb towards a direction. */
function hingeTurns(frame, kind, towards) {
  const { hinge, end } = limbOf(frame, kind)
  return [turnTowards(frame, [hinge], end, towards)]
}

/** Turns a whole limb towards a direction. */
function startTurns(frame, kind, towards) {
  const { start, hinge } = limbOf(frame, kind)
  return [turnTowards(frame, [start], hinge, towards)]
}

function turnTowards({ placeOf }, joints, end, towards) {
  const direction = placeOf(end).sub(placeOf(joints[0]))
  return { joints, axis: direction.cross(towards).normalize() }
}

/** Turns all joints of the fingers towards the palm. */
function fistTurns(frame) {
  const { placeOf } = frame
  const { fingers } = leftHand(frame)
  const [index, little, tip] = [
    fingers.get('index')[0],
    fingers.get('little')[0],
    fingers.get('middle')[1],
  ].map(placeOf)
  const across = index.clone().sub(little)
  const palm = tip
    .sub(placeOf(fingers.get('middle')[0]))
    .cross(across)
    .normalize()
  const towards = (name) => (name === 'thumb' ? palm.clone().sub(across.normalize()) : palm)
  return [...fingers].flatMap(([name, joints]) => {
    const { axis } = turnTowards(frame, joints, joints.at(-1), towards(name))
    const turning = name === 'thumb' ? joints.slice(1) : joints
    return turning.map((joint) => ({ joints: [joint], axis }))
  })
}

function atHinge(frame, kind, height) {
  const { start, hinge } = limbOf(frame, kind)
  const point = frame.placeOf(hinge)
  return { point, height: height * point.distanceTo(frame.placeOf(start)) }
}

function atStart(frame, kind, height) {
  const { start, hinge } = limbOf(frame, kind)
  const point = frame.placeOf(start)
  return { point, height: height * point.distanceTo(frame.placeOf(hinge)) }
}

function atTrunk({ trunk, placeOf }) {
  const [base, top] = [trunk.base, trunk.chain.at(-1)].map(placeOf)
  return { point: base.clone().lerp(top, 0.45), height: 1.9 * base.distanceTo(top) }
}
