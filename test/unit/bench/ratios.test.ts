import { describe, expect, it } from 'vitest'
import { readFigures, warnings } from '../../../bench/ratios.mjs'

describe('the guard of the frame', () => {
  const name = 'webgl, composed, moving'

  it('warns, with the old and new value, if a ratio to the face without wrinkles grew by more than 0.05', () => {
    expect(warnings({ [name]: 1.251 }, { [name]: 1.2 })).toEqual([
      expect.stringContaining(
        'webgl, composed, moving has grown from 1.20 to 1.25 times the frame time of the plain face',
      ),
    ])
  })

  it('ignores smaller growth, decreases and new cases', () => {
    expect(warnings({ [name]: 1.249 }, { [name]: 1.2 })).toEqual([])
    expect(warnings({ [name]: 1 }, { [name]: 1.2 })).toEqual([])
    expect(warnings({ new: 9 }, {})).toEqual([])
  })

  it('compares the figures of both renderers and all modes', () => {
    const names = Object.keys(readFigures())
    for (const renderer of ['webgl', 'webgpu']) {
      for (const variant of ['furrow', 'composed']) {
        expect(names).toContain(`${renderer}, ${variant}, moving`)
      }
      expect(names).toContain(`${renderer}, furrow, moving, all maps`)
    }
  })
})
