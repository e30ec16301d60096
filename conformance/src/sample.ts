import type { MapImage } from './map-image.ts'

/** A layer, with images in place of textures. */
export interface SampleLayer {
  name: string
  kind?: 'replace' | 'detail'
  normal: MapImage
  normalScale?: number
  baseColor?: MapImage
  /** In G. */
  roughness?: MapImage
  /** In R. */
  occlusion?: MapImage
  occlusionStrength?: number
  /** In B; the image of the occlusion, where there is one. */
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

/** A blendshape, and how it moves a vertex; at full weight by nothing if it does not say. */
export interface SampleTarget {
  name: string
  move?: (x: number, y: number) => readonly [number, number, number]
}

/** Texture coordinates: (x, 1 - y) of the square times `scale` plus `offset`. */
export interface SampleUvs {
  /** The set that they are in; set 0 then holds others. */
  set?: 0 | 1
  scale?: number
  offset?: readonly [number, number]
  /** `KHR_texture_transform` of the material's normal map. */
  transform?: { scale: readonly [number, number]; offset: readonly [number, number] }
}

/** How a file is stored after it was put together. */
export type Storage = 'quantized' | 'meshopt' | 'draco' | 'ktx2'

/** Contents of a sample file: a square with one material. */
export interface SampleFile {
  layers: readonly SampleLayer[]
  areas: readonly SampleArea[]
  drivers?: readonly object[]
  /** The material's own normal map; a flat surface without. */
  base?: MapImage
  /** The scale of that. */
  baseScale?: number
  targets?: readonly SampleTarget[]
  /** Other nodes of the scene. */
  nodes?: readonly { name: string; translation?: readonly number[] }[]
  uvs?: SampleUvs
  /** Whether the square is two meshes, left and right, that share the material. */
  isHalved?: boolean
  /** Spoils or changes the JSON of the file. */
  // biome-ignore lint/suspicious/noExplicitAny: cases break the JSON in ways that no type allows
  edit?: (json: any) => void
  storage?: Storage
}

/** Inputs to set on a loaded file, and the expected activations. */
export interface Pose {
  /** Weights of blendshapes; others are 0. */
  weights?: Readonly<Record<string, number>>
  /** Numbers that the application sets. */
  inputs?: Readonly<Record<string, number>>
  /** Rotations of nodes as quaternions x, y, z, w. */
  rotations?: Readonly<Record<string, readonly number[]>>
  /** Positions of nodes. */
  translations?: Readonly<Record<string, readonly number[]>>
  /** Seconds since the pose before, in one frame; 0 for the first one. */
  seconds?: number
  /** The activation of each area. */
  activations: Readonly<Record<string, number>>
}

/** One rule of the specification, and a file that shows whether an engine follows it. */
export interface Sample {
  /** File name without extension. */
  name: string
  /** The rule in one sentence. */
  rule: string
  /** The heading in docs/FURROW_wrinkle_maps.md under which it stands. */
  section: string
  file: SampleFile
  /** In this order; none where the file must be refused. */
  poses: readonly Pose[]
  /** Whether the poses move the square, so that only activations can be compared. */
  isMoved?: boolean
}
