import { principalStretches, restInverse } from 'furrow/internal'
import { Quaternion, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { seeded } from '../../random.ts'

/** Returns the principal stretches of a triangle between two shapes. */
function stretchesOf(rest: number[], now: number[]): number[] {
  const out = new Float64Array(2)
  const inverse = restInverse(0, 1, 2, rest) ?? []
  // Tests an offset into the array of inverses.
  principalStretches(out, [9, 9, 9, ...inverse], 3, 0, 1, 2, now)
  return [...out]
}

describe('principalStretches', () => {
  const rest = [0, 0, 0, 2, 0, 0, 1, 3, 0]
  const moved = (move: (point: Vector3) => Vector3) =>
    [0, 3, 6].flatMap((i) => move(new Vector3().fromArray(rest, i)).toArray())

  it('are 1 for a rigid motion', () => {
    const turn = new Quaternion().setFromAxisAngle(new Vector3(1, 2, 3).normalize(), 1.2)
    const [smaller, larger] = stretchesOf(
      rest,
      moved((p) => p.applyQuaternion(turn).add(new Vector3(5, -3, 2))),
    )
    expect(smaller).toBeCloseTo(1, 7)
    expect(larger).toBeCloseTo(1, 7)
  })

  it('are the scales along any two perpendicular axes', () => {
    const random = seeded(3)
    for (let i = 0; i < 20; i++) {
      const [a, b] = [0.2 + random(), 0.2 + random()]
      const turn = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), 6 * random())
      const now = moved((p) => p.applyQuaternion(turn).multiply(new Vector3(a, b, 1)))
      const [smaller, larger] = stretchesOf(rest, now)
      expect(smaller).toBeCloseTo(Math.min(a, b), 6)
      expect(larger).toBeCloseTo(Math.max(a, b), 6)
    }
  })

  it('require a triangle with area', () => {
    expect(restInverse(0, 1, 2, [0, 0, 0, 1, 1, 1, 2, 2, 2])).toBeUndefined()
    expect(restInverse(0, 0, 1, rest)).toBeUndefined()
    expect(stretchesOf(rest, [0, 0, 0, 1, 0, 0, 0.5, 0, 0])[0]).toBe(0)
  })
})
