import { describe, expect, it } from 'vitest'
import { seenParts } from '../../../../studio/src/lines/line-overlay.ts'

/** A line with points 0.5 pixels apart. */
const line = (isSeen: boolean[]) => ({
  x: Float32Array.from(isSeen, (_, i) => i / 2),
  y: new Float32Array(isSeen.length),
  isSeen,
})

describe('a line over the face', () => {
  it('is drawn by points three pixels apart, from its first to its last', () => {
    expect(seenParts(line(Array(16).fill(true)))).toEqual([[0, 6, 12, 15]])
    expect(seenParts(line([true, true]))).toEqual([[0, 1]])
  })

  it('has a part for each stretch that is seen, to the point behind it', () => {
    const isSeen = [true, true, false, false, ...Array(9).fill(true), false, false]
    expect(seenParts(line(isSeen))).toEqual([
      [0, 2],
      [4, 10, 13],
    ])
    expect(seenParts(line([false, false]))).toEqual([])
  })
})
