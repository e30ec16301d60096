import type { MapImage } from './map-image.ts'

/** A layer, with images in place of textures. */
export interface SampleLayer {
  name: string
  kind?: 'replace' | 'detail'
  normal: MapImage
  normalScale?: number
  baseColor?: MapImage
  /** Roughness in G. */
  roughness?: MapImage
  /** Occlusion in R. */
  occlusion?: MapImage
  occlusionStrength?: number
  /** Blood in B. Must be the same image as `occlusion` if there is one. */
  blood?: MapImage
  bloodAmplitude?: number
}

/** An area, with an image in place of a texture. */
export interface SampleArea {
  name: string
  layer?: number
  weights: MapImage
  channel?: 0 | 1 | 2
  combine?: 'sum' | 'max'
  activation?: number
}

/** A blendshape. `move` returns a vertex's offset at full weight; without it, vertices do not move. */
export interface SampleTarget {
  name: string
  move?: (x: number, y: number) => readonly [number, number, number]
}

/** Texture coordinates: `scale` times the position in the square, from 0 at the top left to 1, plus `offset`. */
export interface SampleUvs {
  /** Attribute set, TEXCOORD_0 or TEXCOORD_1. With set 1, set 0 holds different coordinates. */
  set?: 0 | 1
  scale?: number
  offset?: readonly [number, number]
  /** `KHR_texture_transform` of the material's normal map. */
  transform?: { scale: readonly [number, number]; offset: readonly [number, number] }
}

/** Compression applied after encoding. */
export type Storage = 'quantized' | 'meshopt' | 'draco' | 'ktx2'

/** Contents of a sample file: a square with one material. */
export interface SampleFile {
  layers: readonly SampleLayer[]
  areas: readonly SampleArea[]
  drivers?: readonly object[]
  /** Normal map of the material. Default: none. */
  base?: MapImage
  /** Scale of the material's normal map. */
  baseScale?: number
  targets?: readonly SampleTarget[]
  /** Additional nodes of the scene. */
  nodes?: readonly { name: string; translation?: readonly number[] }[]
  uvs?: SampleUvs
  /** Whether the square consists of two meshes, left and right, that share the material. */
  isHalved?: boolean
  /** Edits the JSON before it is written, usually to break a rule. */
  // biome-ignore lint/suspicious/noExplicitAny: cases break the JSON in ways that no type allows
  edit?: (json: any) => void
  storage?: Storage
}

/** Inputs to set on a loaded file, and the expected activations. */
export interface Pose {
  /** Blendshape weights. Default: 0. */
  weights?: Readonly<Record<string, number>>
  /** Inputs that the application sets. */
  inputs?: Readonly<Record<string, number>>
  /** Rotations of nodes as quaternions x, y, z, w. */
  rotations?: Readonly<Record<string, readonly number[]>>
  /** Positions of nodes. */
  translations?: Readonly<Record<string, readonly number[]>>
  /** Duration of the single frame since the previous pose, seconds; 0 for the first pose. */
  seconds?: number
  /** Expected activation of each area. */
  activations: Readonly<Record<string, number>>
}

/** One rule of the specification with a file that tests it. */
export interface Sample {
  /** File name without extension. */
  name: string
  /** Rule in one sentence. */
  rule: string
  /** Heading of the rule in docs/FURROW_wrinkle_maps.md. */
  section: string
  file: SampleFile
  /** Poses in test order. Empty if engines must reject the file. */
  poses: readonly Pose[]
  /** Whether the poses move the square, so that only activations can be compared. */
  isMoved?: boolean
}
