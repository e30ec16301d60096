import { type BakeMesh, type BakeSource, bakeMaps } from 'furrow/author'
import { sharedNormals } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

/** Returns a square of 100 mm in the plane z = 0, with u along +x and v along -y: two triangles without shared vertices. */
function square(): BakeMesh {
  const corners = [0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1]
  const positions: number[] = []
  const uvs: number[] = []
  for (let i = 0; i < 12; i += 2) {
    positions.push(0.1 * corners[i], 0.1 * corners[i + 1], 0)
    uvs.push(corners[i], 1 - corners[i + 1])
  }
  const repeat = (values: number[]) => Float32Array.from(Array.from({ length: 6 }, () => values).flat())
  return {
    positions: Float32Array.from(positions),
    normals: repeat([0, 0, 1]),
    uvs: Float32Array.from(uvs),
    tangents: repeat([1, 0, 0, 1]),
  }
}

/** Returns the surface `z = f(x)`, metres, for vertical rays. `slope` is the derivative of `f`. */
function ridge(f: (x: number) => number, slope: (x: number) => number): BakeSource {
  return {
    closestHit(x, _y, z, _dx, _dy, dz, far, hit) {
      expect(dz).toBe(-1)
      const distance = z - f(x)
      if (!(distance >= 0 && distance <= far)) return false
      const length = Math.hypot(slope(x), 1)
      hit.set([distance, -slope(x) / length, 0, 1 / length])
      return true
    },
    anyHit: () => false,
  }
}

const incline = ridge(
  (x) => 0.1 * x - 0.004,
  () => 0.1,
)

describe('bakeMaps', () => {
  it.each([1, 4, 9, 16])('samples a plane exactly, %d rays per texel', (samples) => {
    const progress: number[] = []
    const { normal, height, misses, emptyTexels, ...rest } = bakeMaps(
      square(),
      incline,
      { size: 16, cage: 0.01, samples, bits: 16 },
      (done, total) => progress.push(done / total),
    )
    expect(rest.occlusion).toBeUndefined()
    expect([misses, emptyTexels]).toEqual([0, 0])
    // A sample on the diagonal of the square counts twice, once per triangle.
    expect(rest.samples).toBeGreaterThanOrEqual(256 * samples)
    expect(rest.samples).toBeLessThanOrEqual(256 * samples + 16 * Math.sqrt(samples))
    expect(progress.at(-1)).toBe(1)
    for (let i = 0; i < 256; i++) {
      const n = [0, 1, 2].map((k) => (2 * normal.data[3 * i + k]) / 65535 - 1)
      expect(n[0] / n[2]).toBeCloseTo(-0.1, 3)
      expect(n[1]).toBeCloseTo(0, 4)
      expect(height.data[i]).toBeCloseTo(10 * (((i % 16) + 0.5) / 16) - 4, 1)
    }
  })

  it('averages detail finer than a texel', () => {
    // Each texel contains two stripes, with slopes 1 and -1.
    const stripes = ridge(
      () => 0,
      (x) => (Math.floor(320 * x) % 2 === 0 ? 1 : -1),
    )
    const fine = bakeMaps(square(), stripes, { size: 16, cage: 0.01, samples: 16 })
    expect(fine.normal.data.every((value, i) => Math.abs(value - [127.5, 127.5, 255][i % 3]) < 1)).toBe(true)
    const coarse = bakeMaps(square(), stripes, { size: 16, cage: 0.01, samples: 1 })
    expect(coarse.normal.data[0]).not.toBe(128)
  })

  it('leaves texels without a hit flat and unoccluded, counts them, and with a margin fills them from neighbours', () => {
    const half = ridge(
      (x) => (x < 0.05 ? 0.002 : -1),
      () => 0,
    )
    const options = { size: 16, cage: 0.01, samples: 4, occlusionRays: 2 }
    const bare = bakeMaps(square(), half, { ...options, margin: 0 })
    expect(bare.emptyTexels).toBe(128)
    expect(bare.misses).toBeGreaterThanOrEqual(512)
    expect(bare.height.data[7]).toBeCloseTo(2, 4)
    expect(bare.height.data[8]).toBe(0)
    expect([...bare.normal.data.subarray(45, 48)]).toEqual([128, 128, 255])
    expect(bare.occlusion!.data.every((value) => value === 255)).toBe(true)
    const filled = bakeMaps(square(), half, { ...options, margin: 2 })
    expect([...filled.height.data.subarray(6, 11)].map((mm) => mm.toFixed(3))).toEqual([
      '2.000',
      '2.000',
      '2.000',
      '2.000',
      '0.000',
    ])
    expect(filled.emptyTexels).toBe(128)
  })

  it('repeats the texture beyond 0..1', () => {
    const moved = square()
    moved.uvs = moved.uvs.map((t, i) => t + (i % 2 === 0 ? -3 : 2))
    const options = { size: 16, cage: 0.01 }
    expect(bakeMaps(moved, incline, options).normal).toEqual(bakeMaps(square(), incline, options).normal)
  })

  it.each([
    ['no hit', {}, 'no ray hit the detailed surface'],
    [
      'size',
      { size: 0.5 },
      'bakeMaps: size out of range, got 0.5, allowed: 1..8192 texels; choose e.g. 1024',
    ],
    ['samples', { samples: 5 }, 'bakeMaps: samples out of range, got 5, allowed: 1, 4, 9, 16; choose 4'],
    ['cage', { cage: Number.NaN }, 'bakeMaps: cage out of range, got NaN, allowed: above 0 metres'],
  ])('refuses %s', (_, options, message) => {
    const nothing = { closestHit: () => false, anyHit: () => false }
    expect(() => bakeMaps(square(), nothing, { size: 4, cage: 0.01, ...options })).toThrow(message)
  })

  it('refuses arrays of inconsistent lengths', () => {
    const options = { size: 4, cage: 0.01 }
    expect(() => bakeMaps({ ...square(), uvs: new Float32Array(10) }, incline, options)).toThrow(
      'differ in length',
    )
    expect(() => bakeMaps({ ...square(), tangents: new Float32Array(18) }, incline, options)).toThrow(
      'differ in length',
    )
    expect(() => bakeMaps({ ...square(), positions: new Float32Array(0) }, incline, options)).toThrow(
      'no triangles',
    )
    const far = { ...square(), uvs: square().uvs.map((t, i) => (i === 2 ? 7 : t)) }
    expect(() => bakeMaps(far, incline, options)).toThrow('a triangle is larger than the texture')
  })
})

describe('sharedNormals', () => {
  it('averages normals of corners at the same position, and keeps the others', () => {
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 0, 0])
    const normals = Float32Array.from([1, 0, 0, 0, 0, 1, 0, 1, 0])
    const root = Math.fround(Math.SQRT1_2)
    expect([...sharedNormals({ positions, normals })]).toEqual([root, root, 0, 0, 0, 1, root, root, 0])
  })

  it('keeps normals that cancel out', () => {
    const positions = new Float32Array(6)
    const normals = Float32Array.from([0, 0, 1, 0, 0, -1])
    expect([...sharedNormals({ positions, normals })]).toEqual([...normals])
  })
})
