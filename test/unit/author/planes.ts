import { type MetricMesh, type SkinCanvas, skinCanvas } from 'furrow/author'
import { type Metric, surfaceMetric } from 'furrow/internal'

/** Returns a flat sheet with positions `u * a + v * b`, millimetres, over a rectangle of the texture. */
export function sheet(
  a: [number, number, number],
  b: [number, number, number],
  [u0, v0, u1, v1] = [0, 0, 1, 1],
): MetricMesh {
  const uvs = [u0, v0, u1, v0, u1, v1, u0, v1]
  const positions: number[] = []
  for (let i = 0; i < 4; i++) {
    for (let k = 0; k < 3; k++) positions.push((uvs[2 * i] * a[k] + uvs[2 * i + 1] * b[k]) / 1000)
  }
  return { positions, uvs, indices: [0, 3, 2, 0, 2, 1] }
}

/** Merges sheets into one mesh. */
export function joined(...sheets: MetricMesh[]): MetricMesh {
  return {
    positions: sheets.flatMap(({ positions }) => Array.from(positions)),
    uvs: sheets.flatMap(({ uvs }) => Array.from(uvs)),
    indices: sheets.flatMap(({ indices = [] }, i) => Array.from(indices, (index) => index + 4 * i)),
  }
}

/** Returns a canvas for drawing: a flat sheet of `width` x `height` millimetres with `texels` x `texels` texels. */
export function flatCanvas(width: number, height: number, texels: number): SkinCanvas {
  return skinCanvas(sheet([width, 0, 0], [0, -height, 0]), texels)
}

/** Returns the metric of a flat sheet of `width` x `height` millimetres with `texels` x `texels` texels. */
export function flatMetric(width: number, height: number, texels: number): Metric {
  return surfaceMetric(sheet([width, 0, 0], [0, -height, 0]), texels)
}

/** Tells whether two maps are equal, byte for byte. */
export const same = (a: ArrayBufferView, b: ArrayBufferView) =>
  Buffer.from(a.buffer, a.byteOffset, a.byteLength).equals(Buffer.from(b.buffer, b.byteOffset, b.byteLength))
