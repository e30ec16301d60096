import {
  parseStrokes,
  type SkinCanvas,
  type Stroke,
  StrokeLayer,
  skinCanvas,
  strokesToHeight,
} from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { across } from '../../strokes.ts'
import { flatCanvas, same, sheet } from './planes.ts'

const strokes = (...list: object[]): Stroke[] => parseStrokes({ version: 1, strokes: list }).strokes

/** Horizontal stroke across the middle of the map, without tapered ends. */
const level = {
  points: across(0.5, 0.05, 0.95),
  width: 4,
  depth: 0.6,
  taper: 0,
}

/** Returns the height at (x, y), millimetres, on a flat sheet. Interpolates between texels. */
function sample(data: Float32Array, canvas: SkinCanvas, x: number, y: number): number {
  return texelAt(data, canvas, x / Math.sqrt(canvas.metric.uu[0]), y / Math.sqrt(canvas.metric.vv[0]))
}

/** Returns the height at the texture coordinates (u, v). Interpolates between texels. */
function texelAt(
  data: Float32Array,
  { metric: { width, height } }: SkinCanvas,
  u: number,
  v: number,
): number {
  const [column, row] = [u * width - 0.5, v * height - 0.5]
  const [x0, y0] = [Math.floor(column), Math.floor(row)]
  const [fx, fy] = [column - x0, row - y0]
  const at = (i: number, k: number) => data[(y0 + k) * width + x0 + i]
  return (1 - fy) * ((1 - fx) * at(0, 0) + fx * at(1, 0)) + fy * ((1 - fx) * at(0, 1) + fx * at(1, 1))
}

const lowestOf = (data: Float32Array) => data.reduce((low, mm) => Math.min(low, mm))
const highestOf = (data: Float32Array) => data.reduce((high, mm) => Math.max(high, mm))

describe('strokesToHeight', () => {
  // An odd number of texels, so that the line at v = 0.5 runs through the centres of a row.
  const canvas = flatCanvas(100, 100, 401)

  it.each([0, 0.4, 1])('gives the stated depth and width with shoulders of %d', (shoulder) => {
    const { data } = strokesToHeight(strokes({ ...level, shoulder, softness: 0.3 }), canvas)
    expect(sample(data, canvas, 50, 50)).toBeCloseTo(-0.6, 3)
    for (const side of [-2, 2]) {
      expect(sample(data, canvas, 50, 50 + side)).toBeCloseTo((-0.6 * (1 - shoulder)) / Math.E, 2)
    }
    expect(lowestOf(data)).toBeGreaterThanOrEqual(-0.6001)
  })

  it('has banks (raised skin beside the valley) only if the shoulder is not 0, and is exactly 0 far away', () => {
    const bare = strokesToHeight(strokes({ ...level, shoulder: 0 }), canvas).data
    expect(highestOf(bare)).toBe(0)
    const full = strokesToHeight(strokes({ ...level, shoulder: 1 }), canvas).data
    // With the default softness of 0.4, a bank is highest about two half widths away from the bottom of the valley.
    expect(highestOf(full)).toBeCloseTo(0.6 * 0.2798, 3)
    expect(sample(full, canvas, 50, 50 + 7 * 2 + 0.5)).toBe(0)
    expect(sample(full, canvas, 50, 50 - 7 * 2 - 0.5)).toBe(0)
  })

  it('has banks with the volume of the valley if the shoulder is 1, for any bank width', () => {
    for (const bank of [10, 17, 30]) {
      const { data } = strokesToHeight(
        strokes({ ...level, width: 8, shoulder: 1, softness: 0, bank }),
        canvas,
      )
      let [valley, banks] = [0, 0]
      for (let y = 0; y < 401; y++) {
        const h = data[y * 401 + 200]
        if (h < 0) valley -= h
        else banks += h
      }
      expect(banks / valley).toBeGreaterThan(0.98)
      // From 3 to 5 half widths beside the line, the depth fades to 0. This fade removes a twentieth of the valley's volume, but none of the banks'.
      expect(banks / valley).toBeLessThan(1.07)
    }
  })

  it('has one convex bulge between two lines whose banks meet', () => {
    const line = (v: number) => ({
      ...level,
      points: across(v, 0.05, 0.95),
      width: 2,
      depth: 1,
      shoulder: 1,
      bank: 10,
    })
    const { data } = strokesToHeight(strokes(line(0.45), line(0.55)), canvas)
    const profile = Array.from({ length: 41 }, (_, i) => sample(data, canvas, 50, 45 + i / 4))
    // Checks the skin between the two bottoms, except for 1 mm beside each bottom.
    for (let i = 4; i <= 36; i++) {
      expect(profile[i - 1] + profile[i + 1] - 2 * profile[i]).toBeLessThan(1e-4)
    }
    const crest = profile.indexOf(Math.max(...profile))
    expect(crest).toBeGreaterThan(14)
    expect(crest).toBeLessThan(26)
    expect(profile[crest]).toBeGreaterThan(0.15)
  })

  it('has no rim: the outer side of a bank has less than a tenth of the slope of the inner side', () => {
    const { data } = strokesToHeight(strokes({ ...level, width: 2, depth: 1, shoulder: 1, bank: 9 }), canvas)
    const profile = Array.from({ length: 45 }, (_, i) => sample(data, canvas, 50, 50 + i / 4))
    const slopes = profile.slice(1).map((height, i) => 4 * (height - profile[i]))
    expect(Math.max(...slopes)).toBeGreaterThan(0.8)
    expect(Math.min(...slopes)).toBeGreaterThan(-0.08)
  })

  describe('on texels as wide as a fine line', () => {
    // 201 texels for 100 mm, as on the temples of a face with maps of 1024 texels. The slanted line runs through the centres of some texels,
    // and between the centres of others.
    const coarse = flatCanvas(100, 100, 201)
    const slanting = {
      points: [
        [0.1, 0.3],
        [0.9, 0.63],
      ],
      width: 1.2,
      depth: 0.5,
      shoulder: 1,
      softness: 0.4,
    }
    /** Returns the steepest slope between vertical neighbours in the columns `from` to `to`. */
    const steepest = (data: Float32Array, from: number, to: number) => {
      let most = 0
      for (let x = from; x < to; x++)
        for (let y = 1; y < 201; y++)
          most = Math.max(most, Math.abs(data[y * 201 + x] - data[(y - 1) * 201 + x]) / 0.5)
      return most
    }

    it('is equally deep at texel centres and between them, not a row of dots', () => {
      const { data } = strokesToHeight(strokes({ ...slanting, taper: 0 }), coarse)
      const depths = Array.from({ length: 120 }, (_, x) =>
        Math.max(...Array.from({ length: 201 }, (_, y) => -data[y * 201 + x + 40])),
      )
      expect(Math.max(...depths) / Math.min(...depths)).toBeLessThan(1.5)
    })

    it('has ends that fade out and are much less steep than its middle', () => {
      const { data } = strokesToHeight(strokes({ ...slanting, width: 1.6, taper: 0.5 }), coarse)
      // The line covers columns 20 to 181. Columns 149 to 181 are at its tapered end.
      expect(steepest(data, 149, 181) / steepest(data, 80, 120)).toBeLessThan(0.35)
    })

    it('keeps its volume', () => {
      const volumeOf = (canvas: SkinCanvas) => {
        const { data } = strokesToHeight(strokes({ ...slanting, taper: 0, shoulder: 0, softness: 0 }), canvas)
        return data.reduce((sum, mm) => sum - mm, 0) * (100 / canvas.metric.width) ** 2
      }
      expect(volumeOf(coarse) / volumeOf(canvas)).toBeCloseTo(1, 1)
    })
  })

  it('is steeper on the left with a lean of 0.5, and equally deep', () => {
    const { data } = strokesToHeight(strokes({ ...level, shoulder: 0, lean: 0.5 }), canvas)
    expect(sample(data, canvas, 50, 50)).toBeCloseTo(-0.6, 3)
    // The line runs to the right, so its left side is above. The half width is 2 mm * 0.5 on the left, and 2 mm * 1.5 on the right.
    expect(sample(data, canvas, 50, 49)).toBeCloseTo(-0.6 / Math.E, 2)
    expect(sample(data, canvas, 50, 53)).toBeCloseTo(-0.6 / Math.E, 2)
  })

  it('raises the left and the right side separately', () => {
    const { data } = strokesToHeight(strokes({ ...level, shoulder: [1, 0] }), canvas)
    // The line runs to the right, so its left side is above, at smaller v.
    expect(sample(data, canvas, 50, 46)).toBeGreaterThan(0.05)
    expect(sample(data, canvas, 50, 54)).toBeLessThan(-0.01)
  })

  describe('with a negative depth', () => {
    const bulge = { ...level, depth: -1.5, width: 20 }

    it('raises a smooth bulge with the stated height and width, without banks', () => {
      const { data } = strokesToHeight(strokes({ ...bulge, shoulder: 1, bank: 30 }), canvas)
      expect(sample(data, canvas, 50, 50)).toBeCloseTo(1.5, 3)
      for (const side of [-1, 1]) {
        expect(sample(data, canvas, 50, 50 + 5 * side)).toBeCloseTo(1.5 * 0.75 ** 2, 2)
        expect(sample(data, canvas, 50, 50 + 10.3 * side)).toBe(0)
      }
      expect(lowestOf(data)).toBe(0)
      const profile = Array.from({ length: 81 }, (_, i) => sample(data, canvas, 50, 40 + i / 4))
      const slopes = profile.slice(1).map((height, i) => 4 * Math.abs(height - profile[i]))
      expect(Math.max(...slopes)).toBeLessThan((3.1 * 1.5) / 20)
    })

    it('leans: a lean of 0.5 makes the left side steeper', () => {
      const { data } = strokesToHeight(strokes({ ...bulge, lean: 0.5 }), canvas)
      expect(sample(data, canvas, 50, 50)).toBeCloseTo(1.5, 3)
      expect(sample(data, canvas, 50, 44.7)).toBe(0)
      expect(sample(data, canvas, 50, 57.5)).toBeCloseTo(1.5 * 0.75 ** 2, 2)
      expect(sample(data, canvas, 50, 65.3)).toBe(0)
    })

    it('is added to valleys and other bulges', () => {
      const alone = strokesToHeight(strokes(bulge), canvas).data
      const valley = strokesToHeight(strokes(level), canvas).data
      const all = strokesToHeight(strokes(bulge, level, bulge), canvas).data
      for (let i = 0; i < all.length; i += 7) expect(all[i]).toBeCloseTo(2 * alone[i] + valley[i], 5)
    })

    it('occludes nothing', () => {
      const layer = new StrokeLayer(canvas)
      layer.draw(strokes(bulge))
      expect(layer.occlusion.data.every((open) => open === 255)).toBe(true)
    })
  })

  it('measures width on the skin, however the texture is stretched', () => {
    const wide = flatCanvas(300, 100, 501)
    const down = { ...level, points: level.points.map(([u, v]) => [v, u]), shoulder: 1 }
    const { data } = strokesToHeight(strokes(down), wide)
    const profile = [-3, -2, -1, 1, 2, 3].map((x) => sample(data, wide, 150 + x, 50))
    const straight = strokesToHeight(strokes({ ...level, shoulder: 1 }), wide).data
    const along = [-3, -2, -1, 1, 2, 3].map((y) => sample(straight, wide, 150, 50 + y))
    profile.forEach((h, i) => {
      expect(h).toBeCloseTo(along[i], 1.5)
    })
  })

  it('measures width on the skin on a sheared texture', () => {
    // Positions are `u * (100, 0, 0) + v * (50, -80, 0)` mm. The strokes run across, down and diagonally through (75, -40).
    const sheared = skinCanvas(sheet([100, 0, 0], [50, -80, 0]), 401)
    const uv = (x: number, y: number) => [(x + (50 / 80) * y) / 100, -y / 80]
    for (const ends of [
      [uv(60, -40), uv(90, -40)],
      [uv(75, -25), uv(75, -55)],
      [uv(65, -30), uv(85, -50)],
    ]) {
      const { data } = strokesToHeight(strokes({ ...level, points: ends, shoulder: 0 }), sheared)
      const [a, b] = ends as [number[], number[]]
      const [dx, dy] = [100 * (b[0] - a[0]) + 50 * (b[1] - a[1]), -80 * (b[1] - a[1])]
      for (const side of [-2, 2]) {
        const [x, y] = [75 - (side * dy) / Math.hypot(dx, dy), -40 + (side * dx) / Math.hypot(dx, dy)]
        const [u, v] = uv(x, y)
        expect(texelAt(data, sheared, u, v)).toBeCloseTo(-0.6 / Math.E, 2)
      }
    }
  })

  it('tapers to nothing at both ends and has full depth between', () => {
    const { data } = strokesToHeight(strokes({ ...level, taper: [0.2, 0.4] }), canvas)
    expect(sample(data, canvas, 5.2, 50)).toBeGreaterThan(-0.01)
    expect(sample(data, canvas, 94.8, 50)).toBeGreaterThan(-0.01)
    // The taper is a smoothstep, which is 0.5 halfway.
    expect(sample(data, canvas, 5 + 0.1 * 90, 50)).toBeCloseTo(-0.3, 2)
    expect(sample(data, canvas, 95 - 0.2 * 90, 50)).toBeCloseTo(-0.3, 2)
    expect(sample(data, canvas, 5 + 0.4 * 90, 50)).toBeCloseTo(-0.6, 2)
    expect(sample(data, canvas, 2, 50)).toBe(0)
  })

  it('exceeds the deeper of two crossing valleys by at most 12%, in any order', () => {
    const down = { ...level, points: level.points.map(([u, v]) => [v, u]), depth: 0.4 }
    const { data } = strokesToHeight(strokes(level, down), canvas)
    const crossing = sample(data, canvas, 50, 50)
    expect(crossing).toBeLessThanOrEqual(-0.6)
    expect(crossing).toBeGreaterThan(-0.6 * 1.03)
    const twice = sample(strokesToHeight(strokes(level, level), canvas).data, canvas, 50, 50)
    expect(twice).toBeCloseTo(-0.6 * 2 ** (1 / 6), 3)
    expect(same(strokesToHeight(strokes(down, level), canvas).data, data)).toBe(true)
  })

  it('follows a Bezier curve', () => {
    // A half circle of radius 20 mm, made of two cubic arcs, whose error is 0.03%.
    const k = 0.2 * 0.5523
    const arc = {
      ...level,
      curve: 'bezier',
      points: [
        [0.3, 0.5],
        [0.3, 0.5 - k],
        [0.5 - k, 0.3],
        [0.5, 0.3],
        [0.5 + k, 0.3],
        [0.7, 0.5 - k],
        [0.7, 0.5],
      ],
    }
    const { data } = strokesToHeight(strokes(arc), canvas)
    for (const angle of [0.4, 1.2, 2.1, 2.8]) {
      const [x, y] = [50 + 20 * Math.cos(angle), 50 - 20 * Math.sin(angle)]
      expect(sample(data, canvas, x, y)).toBeCloseTo(-0.6, 1)
      expect(sample(data, canvas, 50, 50)).toBe(0)
    }
  })

  it('meanders with waviness, deterministically and within the stated depth', () => {
    const wavy = strokes({ ...level, waviness: 1 })
    const { data } = strokesToHeight(wavy, canvas)
    expect(same(strokesToHeight(wavy, canvas).data, data)).toBe(true)
    expect(same(strokesToHeight(strokes(level), canvas).data, data)).toBe(false)
    expect(lowestOf(data)).toBeGreaterThanOrEqual(-0.6001)
    const lowest = Array.from({ length: 90 }, (_, i) => {
      const column = Array.from({ length: 81 }, (_, y) => sample(data, canvas, 5 + i, 46 + y / 10))
      return 46 + column.indexOf(Math.min(...column)) / 10
    }).slice(2, -2)
    // The line may leave its course by 0.4 * width, which is 1.6 mm.
    expect(Math.max(...lowest)).toBeLessThan(51.7)
    expect(Math.min(...lowest)).toBeGreaterThan(48.3)
    expect(Math.max(...lowest) - Math.min(...lowest)).toBeGreaterThan(0.5)
  })

  it('reports its progress', () => {
    const progress: number[] = []
    strokesToHeight(strokes(level, level), flatCanvas(100, 100, 128), (done, total) =>
      progress.push(done / total),
    )
    expect(progress.length).toBeGreaterThan(4)
    expect(progress).toEqual([...progress].sort((a, b) => a - b))
    expect(progress[0]).toBeLessThan(0.5)
    expect(progress.at(-1)).toBe(1)
  })
})
