/**
 * The paper's formulas in float64 on the CPU (C. D. G. Reis, J. M. De Martino, H. C. Batagelo, "Real-time Simulation of Wrinkles",
 * WSCG 2008): the reference that tests compare every GPU path with. Colours and values are linear.
 */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from './blood.ts'
import type { ImageArray } from './image-array.ts'
import { repeat } from './repeat.ts'
import { TOON_LINE } from './toon-line.ts'
import type { Combine, LayerKind } from './types.ts'

/** An area as far as the influence depends on it, apart from its weights. */
export interface ActiveArea {
  /** 0..1 */
  activation: number
  /** Index of the layer whose wrinkles it shows. */
  layer: number
  /** How it combines with others of that layer. */
  combine: Combine
}

/**
 * Samples one channel of an array bilinearly with clamped edges, as a GPU does: texel centres are at (i + 0.5) / width.
 *
 * @param array 8 bits per channel.
 * @param u texture coordinate, repeating outside 0..1.
 * @param v the same, downwards.
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
 * Interpolates the values of texels bilinearly, with clamped edges.
 *
 * @param size of the texture, in texels.
 * @param u texture coordinate, repeating outside 0..1.
 * @param v the same, downwards.
 * @param texel value of the texel in column i and row j.
 */
export function interpolate(
  size: { width: number; height: number },
  u: number,
  v: number,
  texel: (i: number, j: number) => number,
): number {
  return interpolateTexels(size, repeat(u) * size.width - 0.5, repeat(v) * size.height - 0.5, texel)
}

/** `interpolate` at a column and row, which are whole numbers at the centres of texels. */
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
 * The influence of one layer at a point: the paper's sum over all areas of weight times activation, clamped to 1, and no less than
 * that of any area that combines by `max`.
 *
 * @param areas single-channel array, one slice per area.
 * @param active one for each slice, in their order.
 * @param u texture coordinate, repeating outside 0..1.
 * @param v the same, downwards.
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
 * The same as the influence map of the default mode gives it: computed at the texels of the areas, interpolated between them, and
 * clamped to 1 last. Equal to `influence` where no area combines by `max`.
 *
 * @param areas single-channel array, one slice per area.
 * @param active one for each slice, in their order.
 * @param u texture coordinate, repeating outside 0..1.
 * @param v the same, downwards.
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

/** Weight times activation of a layer's areas: the sum over those that add up, and the maximum of the others. */
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
 * Base colour, roughness or occlusion: the material's own value, interpolated towards those of the layers that have one. Where their
 * influences sum to more than 1, they are divided by the sum.
 *
 * @param base the material's own value, linear, any number of channels.
 * @param layers of each the value, with as many channels, and the influence, 0..1.
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
 * What a blood map says at a point: 0 as much as at rest, 1 redder by its amplitude, -1 paler by it. `mixValues` mixes it, times the amplitude
 * of its layer, into a value of 0.
 *
 * @param stored as in the map, 0..1.
 */
export function bloodOf(stored: number): number {
  const steps = stored * 255 - BLOOD_AT_REST
  return Math.abs(steps) < BLOOD_THRESHOLD ? 0 : Math.max(steps / (255 - BLOOD_AT_REST), -1)
}

/**
 * The skin's colour with more or less blood in it, see `BLOOD_ABSORPTION`.
 *
 * @param colour base colour, linear sRGB.
 * @param blood optical depth that green light gains.
 * @returns linear sRGB; the colour itself where blood is 0.
 */
export function bloodColour(colour: readonly number[], blood: number): number[] {
  return colour.map((value, i) => value * Math.exp(-BLOOD_ABSORPTION[i] * blood))
}

/**
 * Micro-shadow: how much of a light's highlight reaches a point whose layers are occluded. What is visible of the sky is taken as a cone
 * around the normal; light from inside of it arrives, and fades outside (D. Chan, "Material Advances in Call of Duty: WWII", 2018).
 * Diffuse light has none: skin scatters it further than these valleys are wide.
 *
 * @param visibility occlusion of the layers over a value of 1, see `mixValues`; 0..1.
 * @param cosine of the angle between the shaded normal and the light, 0..1.
 * @returns a factor of the light's specular reflection, 0..1.
 */
export function microShadow(visibility: number, cosine: number): number {
  // Of the light of a sky that is even, a cone lets through the squared sine of its half angle.
  const squaredCosineOfCone = 1 - visibility
  return cosine ** 2 < squaredCosineOfCone ? cosine ** 2 / squaredCosineOfCone : 1
}

/**
 * Step 4 of the paper's shader: interpolates between two lit colours.
 *
 * @param smooth lit with smooth normals, linear.
 * @param wrinkled lit with wrinkled normals, linear.
 * @param influence 0..1.
 */
export function mixColours(
  smooth: readonly number[],
  wrinkled: readonly number[],
  influence: number,
): number[] {
  return smooth.map((value, i) => lerp(value, wrinkled[i], influence))
}

/** Unpacks a normal as stored in a map, each channel 0..1, to -1..1; it is not normalised. */
export function unpackNormal(rgb: readonly number[]): number[] {
  return rgb.map((value) => value * 2 - 1)
}

/**
 * Lays a detail normal over a base normal by reoriented normal mapping: the detail is rotated as (0, 0, 1) is to the base
 * (C. Barre-Brisebois, S. Hill, "Blending in Detail", 2012).
 *
 * @param base unit vector in tangent space, z > -1.
 * @param detail the same.
 * @returns unit vector in tangent space.
 */
export function reorientNormal(base: readonly number[], detail: readonly number[]): number[] {
  const t = [base[0], base[1], base[2] + 1]
  const r = [-detail[0], -detail[1], detail[2]]
  const scale = (t[0] * r[0] + t[1] * r[1] + t[2] * r[2]) / t[2]
  return normalize([t[0] * scale - r[0], t[1] * scale - r[1], t[2] * scale - r[2]])
}

/** The normal of one layer at a point, and its influence there. */
export interface LayerNormal {
  /** How it combines with the skin's own. */
  kind: LayerKind
  /** As in the layer's map, unpacked: in tangent space, not normalised. */
  normal: readonly number[]
  /** 0..1 */
  influence: number
}

/**
 * The normal of the default mode, which is then lit once. Layers that replace are mixed in by their influence, divided by the sum where
 * that exceeds 1; slopes of detail layers are added, in any order, and laid over the result by reoriented normal mapping.
 *
 * @param base normal of the material's own map in tangent space, not normalised.
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
 * Lines of wrinkles on a material that lights in steps (toon), whose steps hide most slopes: the skin's colour is darkened by itself
 * where the wrinkles add to its slope, whatever the light.
 *
 * @param colour linear RGB.
 * @param own normal of the material's own map in tangent space, not normalised.
 * @param mixed normal with wrinkles, the same.
 * @returns linear RGB; the colour itself where the normals are equal.
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
