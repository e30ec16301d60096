/**
 * Reference implementation of all wrinkle shading in float64. Tests compare the output of every shader with it. Colours and values are
 * linear. "The paper" is C. D. G. Reis, J. M. De Martino, H. C. Batagelo, "Real-time Simulation of Wrinkles", WSCG 2008.
 */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from './blood.ts'
import type { ImageArray } from './image-array.ts'
import { SMALLEST_ONSET_RANGE } from './limits.ts'
import { repeat } from './repeat.ts'
import { TOON_LINE } from './toon-line.ts'
import type { Combine, LayerKind } from './types.ts'

/** State of an area of influence. Its weights are in an `ImageArray`. */
export interface ActiveArea {
  /** 0..1 */
  activation: number
  /** Index of the layer. */
  layer: number
  /** How the area combines with other areas of the same layer. */
  combine: Combine
}

/**
 * Samples one channel of an array bilinearly with clamped edges, as a GPU does. Texel centres are at `(i + 0.5) / width`.
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

/** Does the same as `interpolate` for a position in texels. The centre of the first texel is at column 0 and row 0. */
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
 * Computes the influence of one layer at a point. Two numbers are computed, and the larger one is returned. The first is the paper's
 * sum of `weight * activation` over the layer's `sum` areas, clamped to 1. The second is the maximum of `weight * activation` over its
 * `max` areas.
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
 * Computes the influence of one layer at a point as the GPU's influence map does: influences are computed at texels, interpolated and
 * then clamped to 1. The result equals that of `influence` if no area combines by `max`. The parameters are those of `influence`.
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

/**
 * Delays the influence of a layer by its onset map, so that a wrinkle begins where it is deepest, and grows from there. With strength 1, the
 * result stays 0 while `influence <= onset`. Then it rises, first fast and then more slowly, to 1 at influence 1.
 *
 * @param influence influence of the layer, 0..1.
 * @param onset value of the layer's onset map, 0..1.
 * @param strength 0 = no delay, 1 = delay by the map.
 * @returns the influence with which all maps of the layer are mixed, 0..1. Exactly 1 if `influence` is 1.
 */
export function onsetInfluence(influence: number, onset: number, strength = 1): number {
  const range = Math.max(1 - onset, SMALLEST_ONSET_RANGE)
  const t = Math.min(Math.max(1 - (1 - influence) / range, 0), 1)
  return influence + (t * (2 - t) - influence) * strength
}

/** Returns the sum of `weight * activation` over a layer's `sum` areas, and the maximum over its `max` areas. */
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
 * Mixes base colour, roughness or occlusion: interpolates from the material's value to the layers' values by influence. Influences that
 * sum to more than 1 are divided by their sum.
 *
 * @param base value of the material, linear, with any number of channels.
 * @param layers value and influence (0..1) of each layer that has a map of this kind. Values have as many channels as `base`.
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
 * Decodes a value of a layer's blood map. Callers multiply the result by the layer's amplitude. They mix the products of all layers by
 * `mixValues` with a base of 0.
 *
 * @param stored value in the map, 0..1.
 * @returns change of blood as a fraction of the amplitude, -1..1: positive = redder, negative = paler, 0 = no change.
 */
export function bloodOf(stored: number): number {
  const steps = stored * 255 - BLOOD_AT_REST
  return Math.abs(steps) < BLOOD_THRESHOLD ? 0 : Math.max(steps / (255 - BLOOD_AT_REST), -1)
}

/**
 * Changes the amount of blood in a skin colour. See `BLOOD_ABSORPTION` for the source of the formula.
 *
 * @param colour base colour, linear sRGB.
 * @param blood added optical depth for green light.
 * @returns linear sRGB.
 */
export function bloodColour(colour: readonly number[], blood: number): number[] {
  return colour.map((value, i) => value * Math.exp(-BLOOD_ABSORPTION[i] * blood))
}

/**
 * Computes the fraction of a light's specular reflection that wrinkles leave unshadowed (D. Chan, "Material Advances in Call of Duty:
 * WWII", 2018). The visible sky is modelled as a cone around the normal. Light from inside the cone arrives unchanged; light from outside
 * fades. Diffuse light is not shadowed, because skin scatters it over a distance larger than the width of a wrinkle.
 *
 * @param visibility the layers' occlusion values, mixed by `mixValues` with a base of 1; 0..1.
 * @param cosine cosine of the angle between the shading normal and the direction to the light, 0..1.
 * @returns factor for the light's specular reflection, 0..1.
 */
export function microShadow(visibility: number, cosine: number): number {
  // A uniform sky sends sin(alpha)^2 of its light through a cone with half angle alpha, so visibility = 1 - cos(alpha)^2.
  const squaredCosineOfCone = 1 - visibility
  return cosine ** 2 < squaredCosineOfCone ? cosine ** 2 / squaredCosineOfCone : 1
}

/**
 * Interpolates between two lit colours, as step 4 of the paper's shader does.
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

/** Converts the components of a normal from 0..1, as sampled from a normal map, to -1..1. The result is not normalised. */
export function unpackNormal(rgb: readonly number[]): number[] {
  return rgb.map((value) => value * 2 - 1)
}

/**
 * Lays a detail normal over a base normal by reoriented normal mapping (C. Barre-Brisebois, S. Hill, "Blending in Detail", 2012). The
 * rotation that turns (0, 0, 1) into the base normal is applied to the detail normal.
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
  /** How the normal combines with the normal of the material. */
  kind: LayerKind
  /** Unpacked normal of the layer's map, in tangent space, not normalised. */
  normal: readonly number[]
  /** 0..1 */
  influence: number
}

/**
 * Mixes the normals of all layers into the material's normal, before lighting. First, `replace` layers are mixed by influence;
 * influences that sum to more than 1 are divided by their sum. Then the slopes of `detail` layers are multiplied by their influences and
 * summed. The sum is laid over the result by reoriented normal mapping.
 *
 * @param base normal from the material's normal map in tangent space, not normalised.
 * @returns unit normal in tangent space.
 */
export function mixNormals(base: readonly number[], layers: readonly LayerNormal[]): number[] {
  const replacing = layers.filter((layer) => layer.kind === 'replace')
  const mixed = mixValues(
    base,
    replacing.map(({ normal, influence }) => ({ value: normal, influence })),
  )
  const details = layers.filter((layer) => layer.kind === 'detail')
  if (details.length === 0) return normalize(mixed)
  const slope = (axis: number) =>
    sum(details.map((layer) => (layer.normal[axis] / layer.normal[2]) * layer.influence))
  return reorientNormal(normalize(mixed), normalize([slope(0), slope(1), 1]))
}

/**
 * Draws wrinkles as dark lines on a toon material. A toon material has few steps of brightness, so it would not show most slopes of
 * wrinkles. The colour is darkened where wrinkles change the slope of the normal. The light has no effect on these lines.
 *
 * @param colour linear RGB.
 * @param own normal from the material's normal map in tangent space, not normalised.
 * @param mixed `own` mixed with the wrinkles, in tangent space, not normalised.
 * @returns linear RGB.
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
