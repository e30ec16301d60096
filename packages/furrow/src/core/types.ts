/**
 * An image with one byte per texel. Rows are stored from top to bottom: row 0 is at v = 0, as in glTF. In images of areas, 255 means
 * that wrinkles are fully visible.
 */
export interface GrayImage {
  width: number
  height: number
  /** width x height bytes, linear. */
  data: Uint8Array
}

/** An image with four bytes per texel. Rows are stored from top to bottom: row 0 is at v = 0, as in glTF. */
export interface RgbaImage {
  width: number
  height: number
  /** 4 x width x height bytes. Colours are sRGB. Normals are linear, +Y towards smaller v. */
  data: Uint8Array
}

/**
 * How a layer's normal map combines with the material's normal map.
 *
 * - `replace`: the layer's map contains pores and wrinkles, and is mixed with the material's map.
 * - `detail`: the layer's map contains only wrinkles, and is laid over the material's map by reoriented normal mapping.
 */
export type LayerKind = 'replace' | 'detail'

/** One slice of a texture array that an engine has loaded from a KTX 2 file. */
export interface ArraySlice {
  /** The engine's texture object. */
  array: object
  /** Index in the array. */
  slice: number
  /** Channel that stores a single-channel map, 0 = R to 3 = A. */
  channel: number
}

/**
 * Texture maps of fully wrinkled skin. A face blends up to four layers, because skin creases differently in different expressions.
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
  /** Base colour, sRGB. Base colour, roughness and occlusion replace the material's values where wrinkles are visible. */
  baseColor?: RgbaImage | Slice
  /** Roughness, linear, 255 = 1. */
  roughness?: GrayImage | Slice
  /** Fraction of the ambient light that arrives, linear, 255 = 1. */
  occlusion?: GrayImage | Slice
  /** 0 = no occlusion, 1 = as in the map; default 1. */
  occlusionStrength?: number
  /** Change of blood, linear: 128 = none, 255 = redder by `bloodAmplitude`, 1 = paler by `bloodAmplitude`. Same size as the occlusion maps. */
  blood?: GrayImage | Slice
  /** Amplitude, 0..2: the optical depth for green light that byte 255 of the blood map adds; required with `blood`. See `BLOOD_ABSORPTION`. */
  bloodAmplitude?: number
  /**
   * Influence at which the wrinkle begins to appear, linear: 0 = at any influence, 255 = only at full influence. See `onsetInfluence`.
   * Same size as the occlusion and blood maps.
   */
  onset?: GrayImage | Slice
  /** 0 = the onset map has no effect, 1 = full effect; default 1. */
  onsetStrength?: number
  /** Height of the wrinkled surface, linear, 127.5 = undisplaced skin. Heights displace the surface if relief is turned on. */
  height?: GrayImage | Slice
  /** Height difference between black and white, in metres; required with `height`. */
  heightAmplitude?: number
}

/** How an area combines with other areas of the same layer at a texel: by addition or by the maximum. */
export type Combine = 'sum' | 'max'

/**
 * An area of influence: the location of one controllable group of wrinkles.
 *
 * @typeParam Slice `ArraySlice` if weights may also be slices of texture arrays.
 */
export interface Area<Slice = never> {
  name: string
  /** Weights, 255 = wrinkles fully visible; any size, resampled when packed. */
  weights: GrayImage | Slice
  /** Name of the layer; default: the first layer. */
  layer?: string
  /** Default `sum`. */
  combine?: Combine
  /** Resting activation, 0..1, to which drivers add; default 0. */
  activation?: number
}

/**
 * Authored wrinkles of one face: plain data, independent of the engine.
 *
 * @typeParam Slice `ArraySlice` if maps and weights may also be slices of texture arrays.
 */
export interface WrinkleSet<Slice = never> {
  /** 1 to 4 layers. Maps of one kind, e.g. the normal maps of all layers, must have the same size. */
  layers: Layer<Slice>[]
  /** 1 to 256 areas with unique names. */
  areas: Area<Slice>[]
  /** Drivers compute activations from blendshape weights and other inputs. `new Wrinkles(mesh, set)` adds them. Default: none. */
  drivers?: readonly { type: string }[]
}
