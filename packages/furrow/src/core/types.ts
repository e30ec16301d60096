/**
 * One byte per texel, row by row from the top: row 0 is v = 0, as in glTF. An area in memory holds weights, 255 = wrinkles fully
 * visible; a file in the paper's convention holds the opposite.
 */
export interface GrayImage {
  width: number
  height: number
  /** width x height bytes, linear. */
  data: Uint8Array
}

/** Four bytes per texel, row by row from the top: row 0 is v = 0, as in glTF. */
export interface RgbaImage {
  width: number
  height: number
  /** 4 x width x height bytes; colours are sRGB, normals are linear with +Y towards smaller v. */
  data: Uint8Array
}

/**
 * How a layer's normal map combines with the skin's own. `replace`: it holds pores and wrinkles, and the two are mixed. `detail`: it
 * holds wrinkles only, laid over the skin's own by reoriented normal mapping.
 */
export type LayerKind = 'replace' | 'detail'

/** A map in a texture array of the engine, as KTX 2 files have them. */
export interface ArraySlice {
  /** The engine's texture; opaque to everything without an engine. */
  array: object
  /** Index in the array. */
  slice: number
  /** Channel of a single-channel map, 0 = R to 3 = A. */
  channel: number
}

/**
 * The maps of the skin fully wrinkled.
 *
 * @typeParam Slice `ArraySlice` where maps may also be slices of arrays.
 */
export interface Layer<Slice = never> {
  name: string
  kind: LayerKind
  /** Tangent-space normal map, linear, +Y towards smaller v (glTF's convention). */
  normal: RgbaImage | Slice
  /** Factor on x and y of the normals, 1 by default. */
  normalScale?: number
  /** Skin colour, sRGB. This and the two below replace the material's own map where wrinkles show. */
  baseColor?: RgbaImage | Slice
  /** Roughness, linear, 255 = 1. */
  roughness?: GrayImage | Slice
  /** Fraction of the ambient light that arrives, linear, 255 = 1. */
  occlusion?: GrayImage | Slice
  /** 0 = no occlusion, 1 = as in the map; 1 by default. */
  occlusionStrength?: number
  /**
   * Blood in the skin, which absorbs light, linear: 128 = as much as at rest, 255 = redder by `bloodAmplitude`, 1 = paler by it. Of the
   * size of the occlusion maps.
   */
  blood?: GrayImage | Slice
  /** Optical depth that green light gains from 128 to 255, 0..2; required with `blood`. See `BLOOD_ABSORPTION`. */
  bloodAmplitude?: number
  /** Height of the surface where wrinkles show, linear, 127.5 = the skin itself; drawn as relief. */
  height?: GrayImage | Slice
  /** Metres from black to white of the heights; required with `height`. */
  heightAmplitude?: number
}

/** How an area combines with others of its layer at the same texel: added, or the maximum of both. */
export type Combine = 'sum' | 'max'

/**
 * An area of influence: where one controllable group of wrinkles is.
 *
 * @typeParam Slice `ArraySlice` where weights may also be slices of arrays.
 */
export interface Area<Slice = never> {
  name: string
  /** Weights, 255 = fully visible; any size, resampled when packed. */
  weights: GrayImage | Slice
  /** Name of the layer whose wrinkles it shows; the first layer by default. */
  layer?: string
  /** `sum` by default. */
  combine?: Combine
  /** Activation at rest, 0..1, 0 by default. */
  activation?: number
}

/**
 * All that an artist makes for one face: plain data, independent of any engine.
 *
 * @typeParam Slice `ArraySlice` where maps and weights may also be slices of arrays.
 */
export interface WrinkleSet<Slice = never> {
  /** 1 to 4 layers; all maps of one kind have one size. */
  layers: Layer<Slice>[]
  /** 1 to 256 areas with distinct names. */
  areas: Area<Slice>[]
  /** What activates the areas; `new Wrinkles(mesh, set)` adds them, as `addDrivers` does. None by default. */
  drivers?: readonly { type: string }[]
}
