import type { GrayImage } from 'furrow'
import { packAreas, reference } from 'furrow/internal'
import type { MapImage } from './map-image.ts'
import type { Pose, Sample, SampleFile, SampleLayer } from './sample.ts'

/** Width and height of the expected pictures, pixels. */
export const PIXELS = 32

/** Pixels whose expected values are in the JSON of a sample: column and row, from the top left. */
const LISTED = [
  [3, 3],
  [11, 5],
  [20, 8],
  [27, 12],
  [6, 19],
  [14, 22],
  [23, 26],
  [29, 30],
] as const

/** Values that an engine must compute at one point of a sample's square. */
export interface Expected {
  /** Influence of each layer before its onset map is applied, 0..1. */
  influence: number[]
  /** Normal as a unit vector in tangent space. */
  normal: number[]
  /** Base colour, linear. White without wrinkles. */
  baseColor: number[]
  /** Roughness. 1 without wrinkles. */
  roughness: number
  /** Occlusion. 1 without wrinkles. */
  occlusion: number
}

/** Computes the expected values at the centre of a pixel with the float64 reference. */
export function expectedAt(file: SampleFile, pose: Pose, column: number, row: number): Expected {
  const [u, v] = uvAt(file, (column + 0.5) / PIXELS, (row + 0.5) / PIXELS)
  const weights = file.areas.map(({ weights, channel = 0 }) => channelOf(weights, channel))
  const areas = packAreas(weights, weights[0].width)
  const active = file.areas.map(({ name, layer = 0, combine = 'sum' as const }) => {
    return { activation: pose.activations[name], layer, combine }
  })
  const influence = file.layers.map((_, layer) => reference.influence(areas, active, u, v, layer))
  const delayed = file.layers.map(({ onset, onsetStrength }, i) =>
    onset ? reference.onsetInfluence(influence[i], texel(onset, u, v, 1), onsetStrength) : influence[i],
  )
  const mixed = (own: readonly number[], valuesOf: (layer: SampleLayer) => number[] | undefined) =>
    reference.mixValues(
      own,
      file.layers.flatMap((layer, i) => {
        const value = valuesOf(layer)
        return value ? [{ value, influence: delayed[i] }] : []
      }),
    )
  const [blood] = mixed([0], ({ blood: map, bloodAmplitude = 0 }) => {
    return map && [reference.bloodOf(texel(map, u, v, 2)) * bloodAmplitude]
  })
  const baseColor = mixed([1, 1, 1], ({ baseColor: map }) => map && colourAt(map, u, v))
  return {
    influence,
    normal: scaled(
      reference.mixNormals(
        file.base ? normalAt(file.base, u, v) : [0, 0, 1],
        file.layers.map(({ kind = 'replace', normal, normalScale = 1 }, i) => {
          const [x, y, z] = normalAt(normal, u, v)
          return { kind, normal: [x * normalScale, y * normalScale, z], influence: delayed[i] }
        }),
      ),
      file.baseScale ?? 1,
    ),
    baseColor: reference.bloodColour(baseColor, blood),
    roughness: mixed([1], ({ roughness }) => roughness && [texel(roughness, u, v, 1)])[0],
    occlusion: mixed([1], ({ occlusion, occlusionStrength = 1 }) => {
      return occlusion && [1 + occlusionStrength * (texel(occlusion, u, v, 0) - 1)]
    })[0],
  }
}

/** Returns the JSON file of a sample, with its rule and the expected values. */
export function describe(sample: Sample): object {
  const { rule, section, file, poses, isMoved } = sample
  if (poses.length === 0) return { rule, section, refused: true }
  return {
    rule,
    section,
    poses: poses.map((pose) => ({
      ...pose,
      ...(!isMoved && {
        points: LISTED.map(([column, row]) => ({
          column,
          row,
          ...rounded(expectedAt(file, pose, column, row)),
        })),
      }),
    })),
  }
}

/** Renders the expected normals of the square as a picture: `rgb = xyz / 2 + 1 / 2`. */
export function normalPicture(file: SampleFile, pose: Pose): MapImage {
  const data = new Uint8Array(3 * PIXELS * PIXELS)
  for (let i = 0; i < PIXELS * PIXELS; i++) {
    const { normal } = expectedAt(file, pose, i % PIXELS, Math.floor(i / PIXELS))
    data.set(
      normal.map((value) => Math.round((value * 0.5 + 0.5) * 255)),
      3 * i,
    )
  }
  return { width: PIXELS, height: PIXELS, data }
}

/** Rounds to six decimals, which keeps the files short. The tolerance of comparisons is much larger. */
function rounded(expected: Expected): Expected {
  const round = (value: number) => Math.round(value * 1e6) / 1e6
  return {
    influence: expected.influence.map(round),
    normal: expected.normal.map(round),
    baseColor: expected.baseColor.map(round),
    roughness: round(expected.roughness),
    occlusion: round(expected.occlusion),
  }
}

/**
 * Returns the texture coordinates of a point of the square.
 *
 * @param x distance from the left edge, 0..1.
 * @param y distance from the top edge, 0..1.
 */
function uvAt({ uvs = {} }: SampleFile, x: number, y: number): [number, number] {
  const { scale = 1, offset = [0, 0], transform = { scale: [1, 1], offset: [0, 0] } } = uvs
  const at = (value: number, axis: 0 | 1) =>
    (value * scale + offset[axis]) * transform.scale[axis] + transform.offset[axis]
  return [at(x, 0), at(y, 1)]
}

function texel({ width, height, data }: MapImage, u: number, v: number, channel: number): number {
  return reference.interpolate({ width, height }, u, v, (i, j) => data[3 * (i + j * width) + channel]) / 255
}

function normalAt(map: MapImage, u: number, v: number): number[] {
  return reference.unpackNormal([0, 1, 2].map((channel) => texel(map, u, v, channel)))
}

function scaled([x, y, z]: readonly number[], scale: number): number[] {
  const length = Math.hypot(x * scale, y * scale, z)
  return [(x * scale) / length, (y * scale) / length, z / length]
}

/** Samples a colour. Decodes sRGB before interpolation, as GPUs do. */
function colourAt({ width, height, data }: MapImage, u: number, v: number): number[] {
  return [0, 1, 2].map((channel) =>
    reference.interpolate({ width, height }, u, v, (i, j) =>
      linear(data[3 * (i + j * width) + channel] / 255),
    ),
  )
}

/** Converts an sRGB value to linear (IEC 61966-2-1). */
function linear(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4
}

function channelOf({ width, height, data }: MapImage, channel: number): GrayImage {
  return { width, height, data: Uint8Array.from({ length: width * height }, (_, i) => data[3 * i + channel]) }
}
