/**
 * One byte per texel, row by row from the top: row 0 is v = 0, as in glTF. As an area it holds weights,
 * 255 = wrinkles fully visible; as a file in the paper's convention it is the other way round.
 */
export interface GrayImage {
  width: number
  height: number
  /** width x height bytes. */
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
 * How a layer's normal map meets the skin's own. `replace`: it holds pores and wrinkles, the two are mixed.
 * `detail`: it holds wrinkles alone, laid over the skin's own by reoriented normal mapping.
 */
export type LayerKind = 'replace' | 'detail'

/** A map that lies in a texture array of the engine, as KTX2 files give it; nothing in here looks inside. */
export interface ArraySlice {
  array: object
  slice: number
  /** Which channel of it, 0 = R to 3 = A, where a map has only one. */
  channel: number
}

/**
 * The maps of the skin fully wrinkled.
 *
 * @typeParam Slice `ArraySlice` where maps may also come as slices of arrays.
 */
export interface Layer<Slice = never> {
  name: string
  kind: LayerKind
  /** Tangent-space normal map, linear, +Y towards smaller v (glTF's convention). */
  normal: RgbaImage | Slice
  /** Multiplies x and y of the normals; 1 when absent. */
  normalScale?: number
  /** Skin colour, sRGB. This and the two below take the place of the material's own map where wrinkles show. */
  baseColor?: RgbaImage | Slice
  /** Roughness, linear, 255 = 1. */
  roughness?: GrayImage | Slice
  /** Ambient light that comes through, linear, 255 = all of it. */
  occlusion?: GrayImage | Slice
  /** How much of the occlusion is applied, 0..1; 1 when absent. */
  occlusionStrength?: number
}

/** How an area meets others of its layer at the same texel: added, or the larger of the two. */
export type Combine = 'sum' | 'max'

/** An area of influence: where one controllable group of wrinkles lies. */
export interface Area<Slice = never> {
  name: string
  /** Weights, 255 = fully visible; any size, resampled when packed. */
  weights: GrayImage | Slice
  /** Name of the layer whose wrinkles it shows; the first layer when absent. */
  layer?: string
  /** `sum` when absent. */
  combine?: Combine
  /** Activation at rest, 0..1; 0 when absent. */
  activation?: number
}

/** The authored whole: plain data with no engine in it. */
export interface WrinkleSet<Slice = never> {
  /** 1 to 4 layers; maps of one kind share their size. */
  layers: Layer<Slice>[]
  /** 1 to 256 areas with distinct names. */
  areas: Area<Slice>[]
}
