import { FurrowError } from 'furrow'
import { Activations } from 'furrow/internal'
import { afterEach, beforeEach, describe, expect, it, type MockInstance, vi } from 'vitest'

const area = (name: string) => ({ name })

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
  ])('clamps %s to %s, with one warning', (value, clamped) => {
    const activations = new Activations([area('nose')])
    activations.set('nose', value)
    activations.set('nose', value)
    expect(activations.get('nose')).toBe(clamped)
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toBe(
      `Activations: activation of "nose" out of range, got ${value}, allowed: 0 to 1; clamped to ${clamped}; this warning is not repeated`,
    )
  })

  it('refuses an unknown name and lists the known ones', () => {
    const activations = new Activations([area('nose'), area('glabella')])
    expect(() => activations.set('noze', 1)).toThrow(
      new FurrowError({
        code: 'unknown-name',
        who: 'Activations',
        problem: 'unknown area',
        value: 'noze',
        limit: '"nose", "glabella"',
        remedy: 'did you mean "nose"?',
      }),
    )
    expect(activations.version).toBe(1)
  })

  it('increments the version only on changes', () => {
    const activations = new Activations([area('a')])
    const start = activations.version
    activations.set('a', 0.3)
    activations.set('a', 0.3)
    expect(activations.version).toBe(start + 1)
  })

  it('keeps activations by name when areas are added and removed', () => {
    const activations = new Activations([area('a'), area('b'), area('c')])
    activations.set('c', 0.75)
    activations.rebind([area('c'), area('d')])
    expect(activations.get('c')).toBe(0.75)
    expect(activations.get('d')).toBe(0)
    expect(activations.has('a')).toBe(false)
    expect([...activations.values.subarray(0, 3)]).toEqual([0.75, 0, 0])
  })
})
