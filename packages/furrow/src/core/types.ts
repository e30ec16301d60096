/**
 * An image of one byte per texel, row by row from the top: row 0 is v = 0, as in glTF. Areas in memory hold weights, 255 = fully visible;
 * files in the paper's convention are inverted.
 */
export interface GrayImage {
  width: number
  height: number
  /** width x height bytes, linear. */
  data: Uint8Array
}

/** An image of four bytes per texel, row by row from the top: row 0 is v = 0, as in glTF. */
export interface RgbaImage {
  width: number
  height: number
  /** 4 x width x height bytes; colours are sRGB, normals are linear with +Y towards smaller v. */
  data: Uint8Array
}

/**
 * How a layer's normal map combines with the skin's.
 *
 * - `replace`: the map holds pores and wrinkles, and is mixed with the skin's.
 * - `detail`: the map holds only wrinkles, and is laid over the skin's by reoriented normal mapping.
 */
export type LayerKind = 'replace' | 'detail'

/** A map in a texture array of the engine, read from a KTX 2 file. */
export interface ArraySlice {
  /** Texture of the engine. Opaque to engine-free code. */
  array: object
  /** Index in the array. */
  slice: number
  /** Channel of a single-channel map, 0 = R to 3 = A. */
  channel: number
}

/**
 * Maps of the fully wrinkled skin.
 *
 * @typeParam Slice `ArraySlice` if maps may also be slices of texture arrays.
 */
export interface Layer<Slice = never> {
  name: string
  kind: LayerKind
  /** Tangent-space normal map, linear, +Y towards smaller v (glTF's convention). */
  normal: RgbaImage | Slice
  /** Factor for x and y of the normals; default 1. */
  normalScale?: number
  /** Skin colour, sRGB. Like roughness and occlusion, replaces the material's map where wrinkles show. */
  baseColor?: RgbaImage | Slice
  /** Roughness, linear, 255 = 1. */
  roughness?: GrayImage | Slice
  /** Fraction of the ambient light that arrives, linear, 255 = 1. */
  occlusion?: GrayImage | Slice
  /** 0 = no occlusion, 1 = as in the map; default 1. */
  occlusionStrength?: number
  /** Change of blood, linear: 128 = none, 255 = redder by `bloodAmplitude`, 1 = paler by it. Same size as the occlusion maps. */
  blood?: GrayImage | Slice
  /** Optical depth of green at 255, 0..2; required with `blood`. See `BLOOD_ABSORPTION`. */
  bloodAmplitude?: number
  /** Height of the wrinkled surface, linear, 127.5 = undisplaced skin; drawn as relief. */
  height?: GrayImage | Slice
  /** Metres from black to white of the height map; required with `height`. */
  heightAmplitude?: number
}

/** How an area combines with others of its layer at the same texel: by addition, or by the maximum. */
export type Combine = 'sum' | 'max'

/**
 * An area of influence: the location of one controllable group of wrinkles.
 *
 * @typeParam Slice `ArraySlice` if weights may also be slices of texture arrays.
 */
export interface Area<Slice = never> {
  name: string
  /** Weights, 255 = fully visible; any size, resampled when packed. */
  weights: GrayImage | Slice
  /** Name of the layer; default: the first layer. */
  layer?: string
  /** Default `sum`. */
  combine?: Combine
  /** Resting activation, 0..1; default 0. */
  activation?: number
}

/**
 * Authored wrinkles of one face: plain data, independent of the engine.
 *
 * @typeParam Slice `ArraySlice` if maps and weights may also be slices of texture arrays.
 */
export interface WrinkleSet<Slice = never> {
  /** 1 to 4 layers. All maps of one kind must have one size. */
  layers: Layer<Slice>[]
  /** 1 to 256 areas with unique names. */
  areas: Area<Slice>[]
  /** Drivers that `new Wrinkles(mesh, set)` adds, as `addDrivers` does; default none. */
  drivers?: readonly { type: string }[]
}
