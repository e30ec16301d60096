import { describe, expect, it } from 'vitest'
import { ComposePolicy } from '../../../packages/furrow/src/three/material/auto/compose-policy.ts'

const LARGE = 300 * 300
const SMALL = 40 * 40

/** Of which the face covers too few pixels to be redrawn for each of its movements. */
const TEXELS = 128 * 128

/** How many of some frames were to be drawn with a composed map. */
function composed(policy: ComposePolicy, frames: number, hasMoved = false, pixels = LARGE): number {
  return Array.from({ length: frames }, () => policy.step(hasMoved, pixels, TEXELS)).filter(Boolean).length
}

describe('when a face is composed', () => {
  it('is after it was still for some frames', () => {
    const policy = new ComposePolicy()
    expect(composed(policy, 30)).toBe(0)
    expect(composed(policy, 100)).toBe(100)
  })

  it('is not at the first frame that moves, nor while it moves now and then', () => {
    const policy = new ComposePolicy()
    composed(policy, 40)
    expect(composed(policy, 1, true)).toBe(0)
    for (let i = 0; i < 20; i++) expect(composed(policy, 1, true) + composed(policy, 29)).toBe(0)
  })

  it('is not while the face is small', () => {
    expect(composed(new ComposePolicy(), 100, false, SMALL)).toBe(0)
  })

  it('is while it moves and covers many times more pixels than are redrawn, until it covers clearly fewer', () => {
    const policy = new ComposePolicy()
    expect(composed(policy, 100, true, 7 * TEXELS)).toBe(0)
    expect(composed(policy, 30, true, 9 * TEXELS)).toBe(0)
    expect(composed(policy, 100, true, 9 * TEXELS)).toBe(100)
    expect(composed(policy, 100, true, 7 * TEXELS)).toBe(100)
    expect(composed(policy, 100, true, 5 * TEXELS)).toBe(0)
    expect(composed(policy, 100, true, 7 * TEXELS)).toBe(0)
  })
})
