import {
  combineNormals,
  type HeightMap,
  heightToNormal,
  type Stroke,
  StrokeLayer,
  skinCanvas,
} from 'furrow/author'
import { resampleHeights, sculptedHeight } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { cylinder, uvOf } from './skins.ts'

const SIZE = 64
const canvas = skinCanvas(cylinder(), SIZE)
const WHOLE = { x0: 0, y0: 0, x1: SIZE, y1: SIZE }

const lineOf = (depth: number): Stroke => ({
  curve: 'spline',
  points: [0.3, 0.5].map((turn) => uvOf(turn, 30)),
  width: 12,
  depth,
  taper: [0, 0],
  shoulder: [0.6, 0.6],
  softness: 0.4,
  waviness: 0,
})

/** Heights that rise to the right, so that each texel differs. */
function slope(): HeightMap {
  return {
    width: SIZE,
    height: SIZE,
    data: Float32Array.from({ length: SIZE ** 2 }, (_, i) => (i % SIZE) / SIZE),
  }
}

const copyOf = ({ heights, normal, occlusion }: StrokeLayer) => ({
  heights: heights.data.slice(),
  normal: normal.data.slice(),
  occlusion: occlusion.data.slice(),
})

/** Returns a layer with a stroke, before it has sculpted heights. */
function layerOf(stroke: Stroke, options = {}): StrokeLayer {
  const layer = new StrokeLayer(canvas, options)
  layer.draw([stroke])
  return layer
}

describe('sculpted heights', () => {
  it('are added to the heights of the strokes, and the normals follow from the sum', () => {
    const sculpted = slope()
    const layer = layerOf(lineOf(1))
    const before = copyOf(layer)
    expect(layer.sculpt(sculpted)).toEqual(WHOLE)
    const sum = before.heights.map((mm, i) => mm + sculpted.data[i])
    expect(layer.heights.data).toEqual(sum)
    const { normal, occlusion } = copyOf(layer)
    expect(normal).toEqual(heightToNormal({ ...sculpted, data: sum }, canvas.metric).data)
    expect(occlusion).toEqual(before.occlusion)
  })

  it('are above the imported normal map of the layer', () => {
    const data = Uint8Array.from({ length: 4 * SIZE ** 2 }, (_, i) => (i % 4 > 1 ? 255 : 100 + (i % 50)))
    const base = { width: SIZE, height: SIZE, data }
    const layer = layerOf(lineOf(1), { base })
    layer.sculpt(slope())
    const detail = heightToNormal(layer.heights, canvas.metric)
    expect(layer.normal).toEqual(combineNormals(base, detail))
  })

  it('stay when the strokes change, and the strokes are exact again when they are removed', () => {
    const [sculpted, layer] = [slope(), layerOf(lineOf(1))]
    layer.sculpt(sculpted)
    layer.draw([lineOf(2)])
    const other = layerOf(lineOf(2))
    const plain = copyOf(other)
    other.sculpt(sculpted)
    expect(copyOf(layer)).toEqual(copyOf(other))
    layer.sculpt(null)
    expect(copyOf(layer)).toEqual(plain)
  })

  it('are drawn again only in the rectangle that has changed, and its surroundings', () => {
    const [sculpted, layer] = [slope(), layerOf(lineOf(1))]
    layer.sculpt(sculpted)
    sculpted.data[20 * SIZE + 30] += 0.5
    const changed = { x0: 30, y0: 20, x1: 31, y1: 21 }
    expect(layer.sculpt(sculpted, changed)).toEqual({ x0: 28, y0: 18, x1: 33, y1: 23 })
    const other = layerOf(lineOf(1))
    other.sculpt(sculpted)
    expect(copyOf(layer)).toEqual(copyOf(other))
  })

  it('move skin at most 10 mm, and change no stroke that is higher or deeper by itself', () => {
    expect(sculptedHeight(1, 2)).toBe(3)
    expect(sculptedHeight(6, 6)).toBe(10)
    expect(sculptedHeight(-6, -6)).toBe(-10)
    expect(sculptedHeight(15, 0)).toBe(15)
    expect(sculptedHeight(15, 3)).toBe(15)
    expect(sculptedHeight(15, -3)).toBe(12)
  })

  it('are rejected in another size, to which they can be resampled', () => {
    const half = { width: 32, height: 32, data: new Float32Array(32 ** 2).fill(0.5) }
    expect(() => new StrokeLayer(canvas).sculpt(half)).toThrow('64 x 64')
    expect(resampleHeights(half, SIZE, SIZE).data).toEqual(new Float32Array(SIZE ** 2).fill(0.5))
  })
})
