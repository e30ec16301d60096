import type { GrayImage } from 'furrow'
import { Box3, Vector3 } from 'three'
import type { LayerStroke } from '../document/document.ts'
import type { LineSkin } from './line-skin.ts'

/** Sphere around a part of the face, world space. */
export interface SkinPlace {
  readonly middle: Vector3
  readonly radius: number
}

/** Texels between two probes of an area, and the minimum weight that counts, 0..255. */
const STEP = 4
const LEAST = 64

export function placeOfLines(skin: LineSkin, strokes: readonly LayerStroke[]): SkinPlace | null {
  const points = strokes.flatMap((stroke) => {
    const line = skin.lineOf(stroke)
    if (!line) return []
    return line.triangles.map((triangle, i) =>
      skin.picker.positionOf(triangle, line.weights.subarray(3 * i, 3 * i + 3), new Vector3()),
    )
  })
  return around(points)
}

export function placeOfArea(skin: LineSkin, { width, height, data }: GrayImage): SkinPlace | null {
  const { locator } = skin.canvas
  const points: Vector3[] = []
  const weights = new Float64Array(3)
  for (let y = 0; y < height; y += STEP) {
    for (let x = 0; x < width; x += STEP) {
      if (data[y * width + x] < LEAST) continue
      const triangle = locator.find((x + 0.5) / width, (y + 0.5) / height, weights)
      if (triangle >= 0) points.push(skin.picker.positionOf(triangle, weights, new Vector3()))
    }
  }
  return around(points)
}

function around(points: readonly Vector3[]): SkinPlace | null {
  if (points.length === 0) return null
  const box = new Box3().setFromPoints([...points])
  const middle = box.getCenter(new Vector3())
  return { middle, radius: Math.max(box.getSize(new Vector3()).length() / 2, 1e-6) }
}
