import type { MapImage } from './map-image.ts'

/** Layer of a sample file. Its textures are given as images. */
export interface SampleLayer {
  name: string
  kind?: 'replace' | 'detail'
  normal: MapImage
  normalScale?: number
  baseColor?: MapImage
  /** Roughness in the green channel. */
  roughness?: MapImage
  /** Occlusion in the red channel. */
  occlusion?: MapImage
  occlusionStrength?: number
  /** Blood in the blue channel. Must be the same image as `occlusion`, if the layer has occlusion. */
  blood?: MapImage
  bloodAmplitude?: number
  /** Onset in the green channel. Must be the same image as `occlusion` and `blood`, if the layer has these maps. */
  onset?: MapImage
  onsetStrength?: number
}

/** Area of a sample file. Its texture is given as an image. */
export interface SampleArea {
  name: string
  layer?: number
  weights: MapImage
  channel?: 0 | 1 | 2
  combine?: 'sum' | 'max'
  activation?: number
}

/**
 * Blendshape of a sample file. `move` returns the offset of a vertex at weight 1. Without `move`, the blendshape moves
 * nothing.
 */
export interface SampleTarget {
  name: string
  move?: (x: number, y: number) => readonly [number, number, number]
}

/**
 * Texture coordinates of the square: `position * scale + offset`. `position` is 0 at the top left and 1 at the bottom
 * right.
 */
export interface SampleUvs {
  /** Index of the attribute: TEXCOORD_0 or TEXCOORD_1. With TEXCOORD_1, the file also has a TEXCOORD_0 with other values. */
  set?: 0 | 1
  scale?: number
  offset?: readonly [number, number]
  /** `KHR_texture_transform` of the material's normal map. */
  transform?: { scale: readonly [number, number]; offset: readonly [number, number] }
}

/** Compression that is applied after encoding. */
export type Storage = 'quantized' | 'meshopt' | 'draco' | 'ktx2'

/** Content of a sample file: a square with one material. */
export interface SampleFile {
  layers: readonly SampleLayer[]
  areas: readonly SampleArea[]
  drivers?: readonly object[]
  /** Normal map of the material. Default: none. */
  base?: MapImage
  baseScale?: number
  targets?: readonly SampleTarget[]
  nodes?: readonly { name: string; translation?: readonly number[] }[]
  uvs?: SampleUvs
  /** Whether the square consists of a left and a right mesh, which share the material. */
  isHalved?: boolean
  /** Edits the JSON before it is written, usually to break a rule. */
  // biome-ignore lint/suspicious/noExplicitAny: cases break the JSON in ways that no type allows
  edit?: (json: any) => void
  storage?: Storage
}

/** Inputs to set on a loaded file, and the activations that are expected. */
export interface Pose {
  /** Blendshape weights. Default: 0. */
  weights?: Readonly<Record<string, number>>
  /** Inputs that an application would set, such as age. */
  inputs?: Readonly<Record<string, number>>
  /** Rotations of nodes, as quaternions x, y, z, w. */
  rotations?: Readonly<Record<string, readonly number[]>>
  /** Positions of nodes, relative to their parents. */
  translations?: Readonly<Record<string, readonly number[]>>
  /** Seconds between the previous pose and this one, simulated as one frame. 0 for the first pose. */
  seconds?: number
  /** Expected activation of each area. */
  activations: Readonly<Record<string, number>>
}

/** A rule of the specification, with a file that tests it. */
export interface Sample {
  /** File name without extension. */
  name: string
  /** The rule in one sentence. */
  rule: string
  /** Heading of the section in docs/FURROW_wrinkle_maps.md that states the rule. */
  section: string
  file: SampleFile
  /** Poses in the order of the test. Empty if engines must reject the file. */
  poses: readonly Pose[]
  /** Whether the poses move the square. Then a test compares only activations, and no pixels. */
  isMoved?: boolean
}
