/**
 * Reference implementation of the paper in float64 (C. D. G. Reis, J. M. De Martino, H. C. Batagelo, "Real-time Simulation of Wrinkles",
 * WSCG 2008). Tests compare every GPU path with it. Colours and values are linear.
 */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from './blood.ts'
import type { ImageArray } from './image-array.ts'
import { repeat } from './repeat.ts'
import { TOON_LINE } from './toon-line.ts'
import type { Combine, LayerKind } from './types.ts'

/** State of an area that its influence depends on, besides its weights. */
export interface ActiveArea {
  /** 0..1 */
  activation: number
  /** Index of the layer. */
  layer: number
  /** How the area combines with others of its layer. */
  combine: Combine
}

/**
 * Samples one channel of an array bilinearly with clamped edges, as a GPU does. Texel centres are at (i + 0.5) / width.
 *
 * @param array 8 bits per channel.
 * @param u texture coordinate; repeats outside 0..1.
 * @param v texture coordinate, downwards; repeats outside 0..1.
 * @param slice index in the array.
 * @param channel index within a texel.
 * @returns the value, 0..1.
 */
export function sampleArray(array: ImageArray, u: number, v: number, slice: number, channel = 0): number {
  const { width, height, channels, data } = array
  const texel = (i: number, j: number) => data[(i + j * width + slice * width * height) * channels + channel]
  return interpolate(array, u, v, texel) / 255
}

/**
 * Interpolates texels bilinearly with clamped edges.
 *
 * @param size texture size in texels.
 * @param u texture coordinate; repeats outside 0..1.
 * @param v texture coordinate, downwards; repeats outside 0..1.
 * @param texel returns the value in column i and row j.
 */
export function interpolate(
  size: { width: number; height: number },
  u: number,
  v: number,
  texel: (i: number, j: number) => number,
): number {
  return interpolateTexels(size, repeat(u) * size.width - 0.5, repeat(v) * size.height - 0.5, texel)
}

/** `interpolate` at a column and row; integers are texel centres. */
export function interpolateTexels(
  { width, height }: { width: number; height: number },
  column: number,
  row: number,
  texel: (i: number, j: number) => number,
): number {
  const x = Math.min(Math.max(column, 0), width - 1)
  const y = Math.min(Math.max(row, 0), height - 1)
  const x0 = Math.floor(x)
  const y0 = Math.floor(y)
  const x1 = Math.min(x0 + 1, width - 1)
  const y1 = Math.min(y0 + 1, height - 1)
  const top = lerp(texel(x0, y0), texel(x1, y0), x - x0)
  const bottom = lerp(texel(x0, y1), texel(x1, y1), x - x0)
  return lerp(top, bottom, y - y0)
}

/**
 * Computes the influence of one layer at a point: the paper's sum of weight times activation over all areas, clamped to 1, and at least
 * that of every `max` area.
 *
 * @param areas single-channel array, one slice per area.
 * @param active state of each area, in the order of the slices.
 * @param u texture coordinate; repeats outside 0..1.
 * @param v texture coordinate, downwards; repeats outside 0..1.
 * @param layer index of the layer.
 * @returns the influence, 0..1.
 */
export function influence(
  areas: ImageArray,
  active: readonly ActiveArea[],
  u: number,
  v: number,
  layer = 0,
): number {
  const { sum, max } = combine(active, layer, (index) => sampleArray(areas, u, v, index))
  return Math.max(Math.min(sum, 1), max)
}

/**
 * Computes the influence as the influence map of the default mode does: at texels, then interpolated, then clamped to 1. Equals
 * `influence` if no area combines by `max`.
 *
 * @param areas single-channel array, one slice per area.
 * @param active state of each area, in the order of the slices.
 * @param u texture coordinate; repeats outside 0..1.
 * @param v texture coordinate, downwards; repeats outside 0..1.
 * @param layer index of the layer.
 * @returns the influence, 0..1.
 */
export function influenceFromMap(
  areas: ImageArray,
  active: readonly ActiveArea[],
  u: number,
  v: number,
  layer = 0,
): number {
  const { width, height, data } = areas
  const texel = (i: number, j: number) => {
    const weight = (index: number) => data[i + j * width + index * width * height] / 255
    const { sum, max } = combine(active, layer, weight)
    return Math.max(sum, max)
  }
  return Math.min(1, interpolate(areas, u, v, texel))
}

/** Combines weight times activation of a layer's areas: the sum over `sum` areas, and the maximum over `max` areas. */
function combine(
  active: readonly ActiveArea[],
  layer: number,
  weightOf: (index: number) => number,
): { sum: number; max: number } {
  let sum = 0
  let max = 0
  for (const [index, area] of active.entries()) {
    if (area.layer !== layer) continue
    const influence = weightOf(index) * area.activation
    if (area.combine === 'max') max = Math.max(max, influence)
    else sum += influence
  }
  return { sum, max }
}

/**
 * Mixes base colour, roughness or occlusion: interpolates from the material's value to the values of the layers. Influences that sum to
 * more than 1 are divided by the sum.
 *
 * @param base value of the material, linear, any number of channels.
 * @param layers value with the same number of channels, and influence, 0..1, of each layer with such a map.
 */
export function mixValues(
  base: readonly number[],
  layers: readonly { value: readonly number[]; influence: number }[],
): number[] {
  const total = Math.max(1, sum(layers.map((layer) => layer.influence)))
  return base.map(
    (own, i) => own + sum(layers.map((layer) => ((layer.value[i] - own) * layer.influence) / total)),
  )
}

/**
 * Decodes a value of a blood map. The result times the layer's amplitude is mixed by `mixValues` into a base of 0.
 *
 * @param stored value in the map, 0..1.
 * @returns -1..1: 0 = no change, 1 = redder by the amplitude, -1 = paler by the amplitude.
 */
export function bloodOf(stored: number): number {
  const steps = stored * 255 - BLOOD_AT_REST
  return Math.abs(steps) < BLOOD_THRESHOLD ? 0 : Math.max(steps / (255 - BLOOD_AT_REST), -1)
}

/**
 * Changes the amount of blood in a skin colour, see `BLOOD_ABSORPTION`.
 *
 * @param colour base colour, linear sRGB.
 * @param blood added optical depth of green.
 * @returns linear sRGB; the same colour if blood is 0.
 */
export function bloodColour(colour: readonly number[], blood: number): number[] {
  return colour.map((value, i) => value * Math.exp(-BLOOD_ABSORPTION[i] * blood))
}

/**
 * Computes the micro-shadow of occluded wrinkles on a light's highlight (D. Chan, "Material Advances in Call of Duty: WWII", 2018). The
 * visible sky is a cone around the normal: light inside it arrives, light outside fades. Diffuse light is not shadowed, because skin
 * scatters it further than wrinkles are wide.
 *
 * @param visibility mixed occlusion of the layers over a base of 1, see `mixValues`; 0..1.
 * @param cosine cosine of the angle between shading normal and light, 0..1.
 * @returns factor for the light's specular reflection, 0..1.
 */
export function microShadow(visibility: number, cosine: number): number {
  // A cone admits the squared sine of its half angle of a uniform sky's light.
  const squaredCosineOfCone = 1 - visibility
  return cosine ** 2 < squaredCosineOfCone ? cosine ** 2 / squaredCosineOfCone : 1
}

/**
 * Interpolates between two lit colours: step 4 of the paper's shader.
 *
 * @param smooth colour lit with smooth normals, linear.
 * @param wrinkled colour lit with wrinkled normals, linear.
 * @param influence 0..1.
 */
export function mixColours(
  smooth: readonly number[],
  wrinkled: readonly number[],
  influence: number,
): number[] {
  return smooth.map((value, i) => lerp(value, wrinkled[i], influence))
}

/** Unpacks a normal of a map from 0..1 to -1..1, without normalising. */
export function unpackNormal(rgb: readonly number[]): number[] {
  return rgb.map((value) => value * 2 - 1)
}

/**
 * Lays a detail normal over a base normal by reoriented normal mapping (C. Barre-Brisebois, S. Hill, "Blending in Detail", 2012): the
 * rotation from (0, 0, 1) to the base is applied to the detail.
 *
 * @param base unit vector in tangent space, z > -1.
 * @param detail unit vector in tangent space.
 * @returns unit vector in tangent space.
 */
export function reorientNormal(base: readonly number[], detail: readonly number[]): number[] {
  const t = [base[0], base[1], base[2] + 1]
  const r = [-detail[0], -detail[1], detail[2]]
  const scale = (t[0] * r[0] + t[1] * r[1] + t[2] * r[2]) / t[2]
  return normalize([t[0] * scale - r[0], t[1] * scale - r[1], t[2] * scale - r[2]])
}

/** Normal and influence of one layer at a point. */
export interface LayerNormal {
  /** How the normal combines with the skin's. */
  kind: LayerKind
  /** Unpacked normal of the layer's map, in tangent space, not normalised. */
  normal: readonly number[]
  /** 0..1 */
  influence: number
}

/**
 * Mixes normals as the default mode does, before lighting. `replace` layers are mixed in by influence; influences that sum to more than
 * 1 are divided by the sum. Slopes of `detail` layers are added and laid over the result by reoriented normal mapping.
 *
 * @param base normal of the material's map in tangent space, not normalised.
 * @returns unit normal in tangent space.
 */
export function mixNormals(base: readonly number[], layers: readonly LayerNormal[]): number[] {
  const replacing = layers.filter((layer) => layer.kind === 'replace')
  const total = Math.max(1, sum(replacing.map((layer) => layer.influence)))
  const mixed = base.map(
    (value, axis) =>
      value + sum(replacing.map((layer) => ((layer.normal[axis] - value) * layer.influence) / total)),
  )
  const details = layers.filter((layer) => layer.kind === 'detail')
  if (details.length === 0) return normalize(mixed)
  const slope = (axis: number) =>
    sum(details.map((layer) => (layer.normal[axis] / layer.normal[2]) * layer.influence))
  return reorientNormal(normalize(mixed), normalize([slope(0), slope(1), 1]))
}

/**
 * Draws wrinkles as lines on a toon material, whose lighting steps hide most slopes. The colour is darkened where wrinkles add to the
 * slope, independent of the light.
 *
 * @param colour linear RGB.
 * @param own normal of the material's map in tangent space, not normalised.
 * @param mixed normal with wrinkles in tangent space, not normalised.
 * @returns linear RGB; the same colour if the normals are equal.
 */
export function toonColour(
  colour: readonly number[],
  own: readonly number[],
  mixed: readonly number[],
): number[] {
  const [from, to] = TOON_LINE.slopes
  const added = [0, 1].map((axis) => mixed[axis] / mixed[2] - own[axis] / own[2])
  const t = Math.min(1, Math.max(0, (Math.hypot(...added) - from) / (to - from)))
  const line = t * t * (3 - 2 * t)
  return colour.map((value) => value * lerp(1, value * TOON_LINE.shade, line))
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0)
}

function lerp(a: number, b: number, t: number): number {
  return a * (1 - t) + b * t
}

function normalize(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector)
  return vector.map((value) => value / length)
}
