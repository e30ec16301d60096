import { Activations, FurrowError } from 'furrow'
import { afterEach, beforeEach, describe, expect, it, type MockInstance, vi } from 'vitest'

const slot = (name: string, layer = 0, combine: 'sum' | 'max' = 'sum') => ({ name, layer, combine })

describe('Activations', () => {
  let warn: MockInstance
  beforeEach(() => {
    warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
  })
  afterEach(() => warn.mockRestore())

  it.each([
    [Number.NaN, 0],
    [Infinity, 1],
    [-Infinity, 0],
    [-0.1, 0],
    [1.0001, 1],
  ])('takes %s as %s, and says so once', (value, taken) => {
    const activations = new Activations([slot('nose')])
    activations.set('nose', value)
    activations.set('nose', value)
    expect(activations.get('nose')).toBe(taken)
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toBe(
      `Activations: activation of "nose" out of range, got ${value}, allowed: 0 to 1; taken as ${taken}; this is said once`,
    )
  })

  it('refuses an unknown name and tells the known ones', () => {
    const activations = new Activations([slot('nose'), slot('glabella')])
    expect(() => activations.set('noze', 1)).toThrow(
      new FurrowError({
        who: 'Activations',
        what: 'unknown area',
        value: 'noze',
        limit: '"nose", "glabella"',
        remedy: 'use the name of an area of this set, or add the area first',
      }),
    )
    expect(activations.version).toBe(1)
  })

  it('writes each value to the row of its rule and the channel of its layer', () => {
    const activations = new Activations([slot('a', 2, 'sum'), slot('b', 1, 'max')])
    activations.set('a', 0.5)
    activations.set('b', 0.25)
    const written = [...activations.table].flatMap((value, index) => (value === 0 ? [] : [[index, value]]))
    expect(written).toEqual([
      [2, 0.5],
      [(256 + 1) * 4 + 1, 0.25],
    ])
  })

  it('counts changes, and only changes', () => {
    const activations = new Activations([slot('a')])
    const start = activations.version
    activations.set('a', 0.3)
    activations.set('a', 0.3)
    expect(activations.version).toBe(start + 1)
  })

  it('keeps activations by name when areas come and go', () => {
    const activations = new Activations([slot('a'), slot('b'), slot('c')])
    activations.set('c', 0.75)
    activations.rebind([slot('c', 1), slot('d')])
    expect(activations.get('c')).toBe(0.75)
    expect(activations.get('d')).toBe(0)
    expect(activations.has('a')).toBe(false)
    expect(activations.table[1]).toBe(0.75)
    expect(activations.table.filter((value) => value !== 0)).toHaveLength(1)
  })
})
