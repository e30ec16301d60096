/**
 * The judge: the paper's formulas in float64 on the CPU (C. D. G. Reis, J. M. De Martino, H. C. Batagelo,
 * "Real-time Simulation of Wrinkles", WSCG 2008). Every GPU path is compared with these numbers.
 */
import type { ImageArray } from './pack.ts'
import { repeat } from './repeat.ts'
import type { Combine, LayerKind } from './types.ts'

/** What the influence of a texel depends on besides the areas' weights. */
export interface AreaActivation {
  /** 0..1 */
  activation: number
  /** Index of the layer the area shows. */
  layer: number
  combine: Combine
}

/**
 * One channel of an array, sampled bilinearly with its edges clamped, as a GPU does: texel centres lie at
 * (i + 0.5) / width. Outside 0..1 it repeats.
 *
 * @returns the value in 0..1.
 */
export function sampleArray(array: ImageArray, u: number, v: number, layer: number, channel = 0): number {
  const { width, height, channels, data } = array
  const texel = (i: number, j: number) => data[(i + j * width + layer * width * height) * channels + channel]
  return interpolate(array, u, v, texel) / 255
}

/** Interpolates bilinearly between the values of texels; edges are clamped, and outside 0..1 it repeats. */
export function interpolate(
  { width, height }: { width: number; height: number },
  u: number,
  v: number,
  texel: (i: number, j: number) => number,
): number {
  const x = Math.min(Math.max(repeat(u) * width - 0.5, 0), width - 1)
  const y = Math.min(Math.max(repeat(v) * height - 0.5, 0), height - 1)
  const x0 = Math.floor(x)
  const y0 = Math.floor(y)
  const x1 = Math.min(x0 + 1, width - 1)
  const y1 = Math.min(y0 + 1, height - 1)
  const top = lerp(texel(x0, y0), texel(x1, y0), x - x0)
  const bottom = lerp(texel(x0, y1), texel(x1, y1), x - x0)
  return lerp(top, bottom, y - y0)
}

/**
 * How much of one layer's wrinkles shows at a point: the paper's sum over all areas of weight times
 * activation, kept within 1, and no less than any single area that combines by `max`.
 *
 * @param areas single-channel array, one layer per area; its length must match `activations`.
 * @returns influence in 0..1.
 */
export function influence(
  areas: ImageArray,
  activations: readonly AreaActivation[],
  u: number,
  v: number,
  layer = 0,
): number {
  const { added, largest } = combine(activations, layer, (index) => sampleArray(areas, u, v, index))
  return Math.max(Math.min(added, 1), largest)
}

/**
 * The influence map: the same, but formed at the texels of the areas and interpolated between them, cut off
 * at 1 at the very end. Where no area combines by `max` the two are equal.
 *
 * @param areas single-channel array, one layer per area; its length must match `activations`.
 * @returns influence in 0..1.
 */
export function influenceFromMap(
  areas: ImageArray,
  activations: readonly AreaActivation[],
  u: number,
  v: number,
  layer = 0,
): number {
  const { width, height, data } = areas
  const texel = (i: number, j: number) => {
    const weight = (index: number) => data[i + j * width + index * width * height] / 255
    const { added, largest } = combine(activations, layer, weight)
    return Math.max(added, largest)
  }
  return Math.min(1, interpolate(areas, u, v, texel))
}

/** The shares of a layer's areas that add up, as their sum, and the largest of the others. */
function combine(
  activations: readonly AreaActivation[],
  layer: number,
  weightOf: (index: number) => number,
): { added: number; largest: number } {
  let added = 0
  let largest = 0
  for (const [index, area] of activations.entries()) {
    if (area.layer !== layer) continue
    const share = weightOf(index) * area.activation
    if (area.combine === 'max') largest = Math.max(largest, share)
    else added += share
  }
  return { added, largest }
}

/**
 * Base colour, roughness or occlusion: the material's own value turned towards those of the layers that have one,
 * shared out where their influences together exceed 1.
 *
 * @param base, layers' values linear.
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

/** Step 4 of the paper's shader: the colour lit with smooth normals, turned towards the wrinkled one. */
export function mixColours(smooth: readonly number[], wrinkled: readonly number[], amount: number): number[] {
  return smooth.map((value, i) => lerp(value, wrinkled[i], amount))
}

/** A normal as stored in a map (each channel 0..1), unpacked to -1..1; not normalised. */
export function unpackNormal(rgb: readonly number[]): number[] {
  return rgb.map((value) => value * 2 - 1)
}

/**
 * Lays a detail normal over a base normal by reoriented normal mapping: the detail is rotated by the turn
 * that takes (0, 0, 1) to the base (C. Barre-Brisebois, S. Hill, "Blending in Detail", 2012).
 *
 * @param base, detail unit vectors in tangent space, z > -1.
 */
export function reorientNormal(base: readonly number[], detail: readonly number[]): number[] {
  const t = [base[0], base[1], base[2] + 1]
  const r = [-detail[0], -detail[1], detail[2]]
  const scale = (t[0] * r[0] + t[1] * r[1] + t[2] * r[2]) / t[2]
  return normalize([t[0] * scale - r[0], t[1] * scale - r[1], t[2] * scale - r[2]])
}

/** One layer of the default path. */
export interface LayerShare {
  kind: LayerKind
  /** Normal of the layer's map in tangent space, not normalised. */
  normal: readonly number[]
  /** 0..1 */
  influence: number
}

/**
 * The default path: normals mixed first, then lit once. Layers that replace are mixed in by their influence
 * (shared out where together they exceed 1); layers of detail add up as slopes, which no order can change,
 * and are laid over the result by reoriented normal mapping.
 *
 * @param base normal of the smooth map in tangent space, not normalised.
 * @returns unit normal in tangent space.
 */
export function mixNormals(base: readonly number[], layers: readonly LayerShare[]): number[] {
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

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0)
}

function lerp(from: number, to: number, amount: number): number {
  return from * (1 - amount) + to * amount
}

function normalize(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector)
  return vector.map((value) => value / length)
}
