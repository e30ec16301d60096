import type { Skin } from 'furrow/author'
import { type Metric, surfaceMetric } from 'furrow/internal'
import type { FlatPoint } from './alike.ts'

type Uv = readonly [u: number, v: number]

/** Width and height of the metric in texels. */
const SIZE = 256

/**
 * Converts texture coordinates to flat charts in millimetres. All faces of the builder have the same layout of texture coordinates, so lines of
 * different people can be compared on one skin.
 */
export class SkinCharts {
  readonly #metric: Metric

  /** @param scale millimetres per unit of the skin's positions. */
  constructor(skin: Skin, scale: number) {
    this.#metric = surfaceMetric(skin, SIZE, SIZE, scale)
  }

  /** Returns an affine function from texture coordinates to millimetres. Its metric is the mean metric of the skin at `points`. */
  chartAt(points: readonly Uv[]): (uv: Uv) => FlatPoint {
    const { uu, uv, vv } = this.#metric
    const texels = points.map(([u, v]) => texelAt(v) * SIZE + texelAt(u))
    const mean = (map: Float32Array) => texels.reduce((sum, texel) => sum + map[texel]!, 0) / texels.length
    const [a, b, c] = [mean(uu), mean(uv), mean(vv)]
    // Square root of the symmetric matrix [a b; b c].
    const root = Math.sqrt(a * c - b * b)
    const scale = 1 / Math.sqrt(a + c + 2 * root)
    return ([u, v]) => [scale * ((a + root) * u + b * v), scale * (b * u + (c + root) * v)]
  }
}

function texelAt(coordinate: number): number {
  return Math.min(SIZE - 1, Math.floor(coordinate * SIZE))
}
