import type { FaceView } from 'furrow/three'

/** A distant lamp, in the axes of glTF: the face looks along +Z, and +X is its left side. */
export interface Lamp {
  /** Where its light comes from. */
  from: readonly [x: number, y: number, z: number]
  /** Irradiance of a surface that faces it: the `intensity` of three.js's directional lights, and the strength of Blender's suns. */
  strength: number
}

/** One picture of a face, drawn by both renderers. */
export interface Shot {
  name: string
  /** The face, and the age for which its wrinkles are made. */
  face: 'human' | 'scan'
  age: number
  /** Weights of blendshapes, 0..1. */
  targets: Record<string, number>
  view: FaceView
  /** Whether three.js moves the surface by the heights of layers, `on` by default. */
  relief?: 'off' | 'on'
  /** The part of the picture that is compared by number, as fractions of its sides. */
  crop: { left: number; top: number; width: number; height: number }
}

/** Grazing from above and from the person's right, so that wrinkles have shade; a weak one from the left; one from behind for the outline. */
export const LAMPS: readonly Lamp[] = [
  { from: [-0.7, 1.1, 0.55], strength: 3 },
  { from: [1, 0.2, 0.7], strength: 0.5 },
  { from: [0.9, 0.8, -1.2], strength: 1.2 },
]

/** Radiance that comes from everywhere else. */
export const SURROUNDINGS = 0.22

/** Pixels of a picture's side. */
export const SIZE = 1000

const both = (name: string, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })

const SURPRISE = { browInnerUp: 1, ...both('browOuterUp') }
const FROWN = { ...both('browDown'), ...both('noseSneer', 0.4) }
const SMILE = { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) }

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
