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

/** The maps of the skin fully wrinkled. */
export interface Layer {
  name: string
  kind: LayerKind
  /** Tangent-space normal map, linear, +Y towards smaller v (glTF's convention). */
  normal: RgbaImage
  /** Multiplies x and y of the normals; 1 when absent. */
  normalScale?: number
}

/** How an area meets others of its layer at the same texel: added, or the larger of the two. */
export type Combine = 'sum' | 'max'

/** An area of influence: where one controllable group of wrinkles lies. */
export interface Area {
  name: string
  /** Weights, 255 = fully visible; any size, resampled when packed. */
  weights: GrayImage
  /** Name of the layer whose wrinkles it shows; the first layer when absent. */
  layer?: string
  /** `sum` when absent. */
  combine?: Combine
  /** Activation at rest, 0..1; 0 when absent. */
  activation?: number
}

/** The authored whole: plain data with no engine in it. */
export interface WrinkleSet {
  /** 1 to 4 layers, all of one size. */
  layers: Layer[]
  /** 1 to 256 areas with distinct names. */
  areas: Area[]
}
