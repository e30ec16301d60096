import type { AnyHit } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { ambientVisibility } from '../../../packages/furrow/src/author/bake/occlusion.ts'
import { seeded } from '../../random.ts'

const ORIGIN = [0, 0, 0]

/** Random unit vectors, and the six directions along axes, for which building a basis can fail. */
const NORMALS = [
  ...[0, 1, 2].flatMap((k) => [1, -1].map((sign) => [0, 0, 0].with(k, sign))),
  ...Array.from({ length: 20 }, (_, i) => {
    const random = seeded(i)
    const v = [random() - 0.5, random() - 0.5, random() - 0.5]
    return v.map((value) => value / Math.hypot(...v))
  }),
]

describe('ambientVisibility', () => {
  it('is the squared sine of the open cone, for any normal', () => {
    for (const n of NORMALS) {
      for (const angle of [0.3, 0.8, 1.2]) {
        const outside: AnyHit = (_x, _y, _z, dx, dy, dz) =>
          dx * n[0] + dy * n[1] + dz * n[2] < Math.cos(angle)
        expect(
          Math.abs(ambientVisibility(outside, ORIGIN, n, 256, 1, 7) - Math.sin(angle) ** 2),
        ).toBeLessThan(0.01)
      }
    }
  })

  it('is one half beside an endless wall, and all or nothing without walls', () => {
    for (const n of NORMALS) {
      const side = n.map((_, k) => n[(k + 1) % 3] - n[(k + 2) % 3])
      const level = side[0] * n[0] + side[1] * n[1] + side[2] * n[2]
      const wall = side.map((value, k) => value - level * n[k])
      const half: AnyHit = (_x, _y, _z, dx, dy, dz) => dx * wall[0] + dy * wall[1] + dz * wall[2] > 0
      if (Math.hypot(...wall) > 0.1) {
        expect(Math.abs(ambientVisibility(half, ORIGIN, n, 256, 1, 3) - 0.5)).toBeLessThan(0.03)
      }
      expect(ambientVisibility(() => false, ORIGIN, n, 8, 1, 1)).toBe(1)
      expect(ambientVisibility(() => true, ORIGIN, n, 8, 1, 1)).toBe(0)
    }
  })

  it('casts unit vectors from the point with the given length, deterministic per seed', () => {
    const rays = (seed: number) => {
      const seen: number[][] = []
      ambientVisibility((...ray) => seen.push(ray) > 0, [1, 2, 3], [0, 0.6, 0.8], 16, 5, seed)
      return seen
    }
    for (const [x, y, z, dx, dy, dz, far] of rays(1)) {
      expect([x, y, z, far]).toEqual([1, 2, 3, 5])
      expect(Math.hypot(dx, dy, dz)).toBeCloseTo(1, 12)
      expect(0.6 * dy + 0.8 * dz).toBeGreaterThanOrEqual(0)
    }
    expect(rays(1)).toEqual(rays(1))
    expect(rays(1)).not.toEqual(rays(2))
  })
})
