import type { RgbaImage } from 'furrow'
import type { Skin } from 'furrow/author'
import { interpolate } from '../../../../packages/furrow/src/core/reference.ts'
import { dot, minus, plus, scaled, unit, type Vector, vectorAt } from '../../../vectors.ts'
import type { CutSide } from './cuts.ts'

/** Image with any number of channels. */
export interface Channels {
  width: number
  height: number
  channels: number
  data: ArrayLike<number>
}

/** Returns a channel at a UV, with bilinear filtering. */
export function sample(map: Channels, [u, v]: CutSide['uv'], channel = 0): number {
  return interpolate(map, u, v, (i, j) => map.data[map.channels * (j * map.width + i) + channel])
}

/** Returns a normal map and `count` mipmap levels, which average 2 x 2 texels. */
export function levelsOf({ width, height, data }: RgbaImage, count: number): Channels[] {
  const levels: Channels[] = [{ width, height, channels: 4, data }]
  for (const { width, height, data } of levels) {
    if (levels.length > count) break
    const half = new Float32Array(width * height)
    for (let i = 0; i < half.length; i++) {
      const [column, row] = [Math.floor(i / 4) % (width / 2), Math.floor(i / 4 / (width / 2))]
      const first = 4 * (2 * row * width + 2 * column) + (i % 4)
      const [right, below] = [4, 4 * width]
      half[i] = (data[first] + data[first + right] + data[first + below] + data[first + below + right]) / 4
    }
    levels.push({ width: width / 2, height: height / 2, channels: 4, data: half })
  }
  return levels
}

/** Returns the slope that a normal map has at a UV of a triangle: a vector in space, millimetres per millimetre. */
export function slopeIn(skin: Skin, map: Channels, { triangle, uv }: CutSide): number[] {
  const [tangent, bitangent] = tangentFrame(skin, triangle)
  const [x, y, z] = [0, 1, 2].map((k) => sample(map, uv, k) / 127.5 - 1)
  // Byte 128 stands for 0 and decodes to 1 / 255, so subtract it.
  const [along, up] = [x - 1 / 255, y - 1 / 255]
  return tangent.map((value, k) => -(along * value + up * bitangent[k]) / z)
}

/** Returns two orthonormal vectors in the plane of a triangle: one along u, the other towards smaller v. */
function tangentFrame({ positions, uvs, indices }: Skin, triangle: number): readonly [Vector, Vector] {
  const [a, b, c] = [0, 1, 2].map((k) => indices[3 * triangle + k])
  const [u1, v1, u2, v2] = [b, c].flatMap((i) => [0, 1].map((k) => uvs[2 * i + k] - uvs[2 * a + k]))
  const sign = Math.sign(u1 * v2 - u2 * v1)
  const [e1, e2] = [b, c].map((i) => minus(vectorAt(positions, i), vectorAt(positions, a)))
  const tangent = unit(scaled(plus(scaled(e1, v2), e2, -v1), sign))
  const alongV = scaled(plus(scaled(e2, u1), e1, -u2), sign)
  return [tangent, unit(plus(scaled(tangent, dot(tangent, alongV)), alongV, -1))]
}
