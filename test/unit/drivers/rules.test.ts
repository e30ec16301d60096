import type { Curve, Link, Rule, WrinkleDriver } from 'furrow'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { driven } from '../../driven.ts'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'

const names = ['browDownLeft', 'browDownRight', 'browOuterUpLeft']
function activation(rule: Rule, links: Link[], weights: number[], curve = STRAIGHT): number {
  return driven([morph('glabella', links, { rule, curve })], names).activations({ weights }).glabella
}

afterEach(() => vi.restoreAllMocks())

describe('rules', () => {
  const both = [link('browDownLeft', 0.5), link('browDownRight', 0.25)]
  it.each<[Rule, number]>([
    ['sum', 0.8 * 0.5 + 0.4 * 0.25],
    ['max', 0.8 * 0.5],
    ['min', 0.4 * 0.25],
    ['product', 0.8 * 0.5 * 0.4 * 0.25],
  ])('%s', (rule, expected) => {
    expect(activation(rule, both, [0.8, 0.4, 0])).toBeCloseTo(expected, 6)
  })

  it('the rules product and min need both brows', () => {
    const links = [link('browDownLeft'), link('browDownRight')]
    expect(activation('min', links, [1, 0, 0])).toBe(0)
    expect(activation('product', links, [1, 0, 0])).toBe(0)
    expect(activation('min', links, [1, 0.7, 0])).toBeCloseTo(0.7, 6)
  })

  it('a negative weight subtracts', () => {
    const links = [link('browDownLeft'), link('browOuterUpLeft', -0.5)]
    expect(activation('sum', links, [0.9, 0, 0.6])).toBeCloseTo(0.6, 6)
    expect(activation('sum', links, [0.1, 0, 1])).toBe(0)
    expect(activation('max', [link('browDownLeft', -1)], [0.5, 0, 0])).toBe(0)
  })

  it("a link's curve comes before its weight, and the driver's after the rule", () => {
    const late: Curve = ramp(0.5, 1, 2)
    const halved: Curve = ramp(0, 2)
    // The link's curve turns 0.75 into 1, which is multiplied by 0.8. The other link adds 0.4.
    const links = [link('browDownLeft', 0.8, late), link('browDownRight')]
    expect(activation('sum', links, [0.75, 0.4, 0], halved)).toBeCloseTo(0.6, 6)
    expect(activation('sum', links, [0.5, 0.4, 0], halved)).toBeCloseTo(0.2, 6)
  })

  it('a NaN weight counts as 0, with one warning that names it', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { activations } = driven([morph('glabella', both)], names)
    for (let i = 0; i < 3; i++) {
      expect(activations({ weights: [Number.NaN, 0.4, 0] }).glabella).toBeCloseTo(0.1, 6)
    }
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain('driver input "browDownLeft" is not a number')
  })
})

describe('conflicts', () => {
  const resolved = (conflicts: [string, string][], targetNames: string[], weights: number[]) => {
    const { activations, missing } = driven(
      [
        ...['browOuterUpLeft', 'browDownLeft'].map((name) => morph(name, name)),
        ...conflicts.map((targets): WrinkleDriver => ({ type: 'conflict', targets })),
      ],
      targetNames,
    )
    const values = Object.values(activations({ weights }))
    return { activations: values.map((value) => Math.round(1000 * value) / 1000), missing }
  }
  const pair: [string, string] = ['browOuterUpLeft', 'browDownLeft']

  it.each([
    { raised: 0.7, lowered: 0.7, left: [0, 0] },
    { raised: 0.9, lowered: 0.2, left: [0.7, 0] },
    { raised: 0.1, lowered: 0.6, left: [0, 0.5] },
    { raised: 0.8, lowered: 0, left: [0.8, 0] },
    { raised: 0.8, lowered: -0.5, left: [0.8, 0] },
  ])('raised by $raised and lowered by $lowered leaves $left', ({ raised, lowered, left }) => {
    expect(resolved([pair], pair, [raised, lowered]).activations).toEqual(left)
  })

  it("does not change the mesh's weights, and finds halves and other spellings", () => {
    const weights = [0.5, 0.3, 0.2]
    const targets = ['browDown_L', 'browOuterUp_L', 'jawOpen']
    expect(resolved([pair], targets, weights).activations).toEqual([0, 0.2])
    expect(weights).toEqual([0.5, 0.3, 0.2])
  })

  it('continues without missing targets, and lists them', () => {
    const { activations, missing } = resolved(
      [['browOuterUpLeft', 'tail']],
      ['browOuterUpLeft', 'browDownLeft'],
      [0.5, 0.5],
    )
    expect(activations).toEqual([0.5, 0.5])
    expect(missing).toEqual(['target "tail" of a driver of type "conflict"'])
  })
})
