import type { FaceView } from 'furrow/three'

/** A directional light, in glTF's axes. The face looks along +Z, and +X points to the person's left. */
export interface Lamp {
  /** Direction to the light. */
  from: readonly [x: number, y: number, z: number]
  /** Irradiance of a surface facing the light: `intensity` in three.js, strength of a sun in Blender. */
  strength: number
}

/** A picture that both three.js and Cycles render. */
export interface Shot {
  name: string
  /** `human` is `faces/human.glb`. `scan` is a scanned head that is not part of the repository. */
  face: 'human' | 'scan'
  /** Age option of `furrow auto`, years. */
  age: number
  /** Weights of blendshapes, 0..1. */
  targets: Record<string, number>
  view: FaceView
  /** Whether height maps displace the surface in three.js. Default: on. */
  relief?: 'off' | 'on'
  /** Rectangle in which the pictures are compared, as fractions of their width and height. */
  crop: { left: number; top: number; width: number; height: number }
}

/** A grazing key light from above and the person's right, a weak fill from the left, and a rim light from behind. */
export const LAMPS: readonly Lamp[] = [
  { from: [-0.7, 1.1, 0.55], strength: 3 },
  { from: [1, 0.2, 0.7], strength: 0.5 },
  { from: [0.9, 0.8, -1.2], strength: 1.2 },
]

export const AMBIENT = 0.22

/** Width and height of pictures, pixels. */
export const SIZE = 1000

const both = (name: string, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })

const SURPRISE = { browInnerUp: 1, ...both('browOuterUp') }
const FROWN = { ...both('browDown'), ...both('noseSneer', 0.4) }
const SMILE = { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) }

/** The picture that compares engines. It is not compared with Cycles by number. */
export const ENGINES_SHOT: Omit<Shot, 'crop'> = {
  name: 'engines',
  face: 'human',
  age: 45,
  targets: { ...SURPRISE, ...both('mouthSmile', 0.7) },
  view: { yaw: 10, pitch: 4, zoom: 1.5 },
  relief: 'off',
}

const FOREHEAD = { left: 0.25, top: 0.1, width: 0.5, height: 0.3 }

export const SHOTS: readonly Shot[] = [
  {
    name: 'surprise',
    face: 'human',
    age: 70,
    targets: SURPRISE,
    view: { yaw: 10, pitch: 4, zoom: 2 },
    crop: FOREHEAD,
  },
  {
    name: 'profile',
    face: 'human',
    age: 70,
    targets: SURPRISE,
    view: { yaw: -88, pitch: 3, zoom: 2 },
    crop: { left: 0.78, top: 0.12, width: 0.2, height: 0.28 },
  },
  {
    name: 'frown',
    face: 'human',
    age: 70,
    targets: FROWN,
    view: { yaw: 12, pitch: 2, zoom: 2.2 },
    crop: { left: 0.3, top: 0.2, width: 0.4, height: 0.35 },
  },
  {
    name: 'smile',
    face: 'human',
    age: 70,
    targets: SMILE,
    view: { yaw: -38, pitch: 2, zoom: 1.7 },
    crop: { left: 0.2, top: 0.3, width: 0.5, height: 0.4 },
  },
  {
    name: 'scan',
    face: 'scan',
    age: 70,
    targets: SURPRISE,
    view: { yaw: 10, pitch: 4, zoom: 2 },
    crop: FOREHEAD,
  },
]
