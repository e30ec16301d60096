import type { MorphDriver } from 'furrow'
import { curveAt } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { driven } from '../../driven.ts'
import { link, morph } from '../../drivers.ts'

describe('curveAt', () => {
  const late: MorphDriver['curve'] = [
    [0.2, 0.1],
    [0.4, 0.9],
    [1, 0.5],
  ]
  it.each([
    [-5, 0.1],
    [0.2, 0.1],
    [0.3, 0.5],
    [0.4, 0.9],
    [0.7, 0.7],
    [2, 0.5],
    [Number.NaN, 0.1],
  ])('at %s is %s', (input, output) => expect(curveAt(late, input)).toBeCloseTo(output, 12))
})

describe('morph drivers', () => {
  it('sum the weighted targets of a driver, and the drivers of an area to at most 1', () => {
    const { activations } = driven(
      [
        morph('forehead', [link('browInnerUp', 0.5), link('browOuterUpLeft', 0.25)]),
        morph('forehead', 'eyeWideLeft'),
        morph('nose', 'noseSneerLeft'),
      ],
      ['browInnerUp', 'browOuterUpLeft', 'eyeWideLeft', 'noseSneerLeft'],
    )
    const at = (...weights: number[]) => activations({ weights })
    expect(at(1, 0.4, 0.1, 0)).toEqual({ forehead: expect.closeTo(0.7, 6), nose: 0 })
    expect(at(1, 1, 1, 0.3)).toEqual({ forehead: 1, nose: expect.closeTo(0.3, 6) })
    expect(at(0, 0, 0, 0)).toEqual({ forehead: 0, nose: 0 })
  })

  it('find blendshapes in other spellings, and count the mean of left and right halves', () => {
    const { activations } = driven(
      [morph('forehead', 'browInnerUp')],
      ['blendShape1.browInnerUp_L', 'blendShape1.browInnerUp_R'],
    )
    expect(activations({ weights: [1, 1] }).forehead).toBe(1)
    expect(activations({ weights: [1, 0] }).forehead).toBe(0.5)
  })

  it('ignore blendshapes that the mesh lacks, and list them', () => {
    const { activations, missing } = driven([morph('nose', 'trunkUp')], ['jawOpen'])
    expect(activations({ weights: [1] })).toEqual({ nose: 0 })
    expect(missing).toEqual(['target "trunkUp" of a driver of area "nose"'])
  })
})
