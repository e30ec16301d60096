import type { GrayImage, Layer, RgbaImage } from 'furrow'
import { packGrays, reference } from 'furrow/internal'
import { randomImage } from '../cases.ts'

/** Width and height of the maps, texels. */
export const MAP = 16

export const KINDS = ['baseColor', 'roughness', 'occlusion', 'blood'] as const
export type Kind = (typeof KINDS)[number]

/** Sets of layers: for each layer, the kinds of maps that it has. */
export const LAYERS: Kind[][][] = [
  [['baseColor']],
  [['roughness']],
  [['occlusion']],
  [['baseColor', 'roughness', 'occlusion']],
  [['baseColor', 'occlusion'], ['roughness'], [], ['baseColor', 'roughness', 'occlusion']],
  [['blood']],
  [['occlusion', 'blood'], ['baseColor', 'blood'], [], ['occlusion']],
]

/** Creates a layer with random maps of some kinds, and flat normals. */
export function randomLayer(random: () => number, name: string, kinds: readonly Kind[]): Layer {
  const gray = (): GrayImage => ({
    width: MAP,
    height: MAP,
    data: Uint8Array.from({ length: MAP * MAP }, () => random() * 256),
  })
  const flat = { width: MAP, height: MAP, data: new Uint8Array(MAP * MAP * 4).fill(128) }
  for (let i = 2; i < flat.data.length; i += 4) flat.data[i] = 255
  return {
    name,
    kind: 'detail',
    normal: flat,
    normalScale: 0,
    occlusionStrength: 0.6,
    bloodAmplitude: 0.8,
    ...(kinds.includes('baseColor') && { baseColor: randomImage(random, MAP) }),
    ...(kinds.includes('roughness') && { roughness: gray() }),
    ...(kinds.includes('occlusion') && { occlusion: gray() }),
    ...(kinds.includes('blood') && { blood: gray() }),
  }
}

/** Returns the value of a layer's map at (u, v), with colours decoded to linear and the layer's strength applied. */
export function layerValue(layer: Layer, kind: Kind, u: number, v: number): number[] {
  if (kind === 'baseColor') return colourAt(layer.baseColor!, u, v)
  const value = reference.sampleArray(packGrays([layer[kind]!]), u, v, 0)
  if (kind === 'blood') return [reference.bloodOf(value) * layer.bloodAmplitude!]
  return [kind === 'occlusion' ? 1 + (value - 1) * layer.occlusionStrength! : value]
}

/** Returns the linear colour of an sRGB image at (u, v). Decodes before interpolation, as GPUs do. */
export function colourAt(image: RgbaImage, u: number, v: number): number[] {
  return [0, 1, 2].map((c) =>
    reference.interpolate(image, u, v, (i, j) => linear(image.data[4 * (i + j * image.width) + c] / 255)),
  )
}

export function linear(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4
}
