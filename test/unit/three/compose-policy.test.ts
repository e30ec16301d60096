import { describe, expect, it } from 'vitest'
import { ComposePolicy } from '../../../packages/furrow/src/three/material/auto/compose-policy.ts'

const LARGE = 300 * 300
const SMALL = 40 * 40

/** How many of some frames were to be drawn with a composed map. */
function composed(policy: ComposePolicy, frames: number, hasMoved = false, pixels = LARGE): number {
  return Array.from({ length: frames }, () => policy.step(hasMoved, pixels)).filter(Boolean).length
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
})
