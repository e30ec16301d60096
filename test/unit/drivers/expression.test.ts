import { readFileSync } from 'node:fs'
import { type Easing, EXPRESSIONS, type Expression, parseWrinkleSetDocument } from 'furrow'
import { ExpressionMix } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

const ARKIT =
  /^(brow(Down|OuterUp)|cheekSquint|eye(Blink|Look(Down|In|Out|Up)|Squint|Wide)|mouth(Dimple|Frown|LowerDown|Press|Smile|Stretch|UpperUp)|noseSneer)(Left|Right)$|^(browInnerUp|cheekPuff|jaw(Forward|Left|Open|Right)|mouth(Close|Funnel|Left|Pucker|Right|Roll(Lower|Upper)|Shrug(Lower|Upper))|tongueOut)$/
const AREAS = parseWrinkleSetDocument(
  JSON.parse(readFileSync(new URL('../../../faces/human/wrinkles.json', import.meta.url), 'utf8')),
).areas.map(({ name }) => name)

const two: Expression[] = [
  { name: 'neutral', targets: {}, activations: {} },
  { name: 'wink', targets: { eyeBlinkLeft: 1 }, activations: { crowsFeetLeft: 0.8 } },
]

describe('ExpressionMix', () => {
  it('moves linearly over the given time, and then stops', () => {
    const mix = new ExpressionMix(two)
    mix.play('wink', 2)
    const seen = [0, 0.5, 0.5, 1, 5].map((delta) => {
      mix.update(delta)
      return [mix.targets[0], mix.activations[0]]
    })
    const expected = [0, 0.25, 0.5, 1, 1].map((share) => [share, Math.fround(0.8) * share])
    for (const [i, pair] of seen.entries()) {
      expect(pair[0]).toBeCloseTo(expected[i][0], 6)
      expect(pair[1]).toBeCloseTo(expected[i][1], 6)
    }
    expect(mix.isFinished).toBe(true)
  })

  it('starts from its current state when reversed midway', () => {
    const mix = new ExpressionMix(two)
    mix.play('wink', 1)
    mix.update(0.5)
    mix.play('neutral', 1)
    mix.update(0)
    expect(mix.targets[0]).toBeCloseTo(0.5, 6)
    mix.update(0.5)
    expect(mix.targets[0]).toBeCloseTo(0.25, 6)
  })

  it('arrives immediately without a duration', () => {
    const mix = new ExpressionMix(two)
    mix.play('wink')
    expect([...mix.targets]).toEqual([1])
    expect(mix.isFinished).toBe(true)
  })

  it('plays several at once, summed to at most 1', () => {
    const mix = new ExpressionMix([
      { name: 'a', targets: { jawOpen: 0.5, browDownLeft: 1 }, activations: { nose: 0.4 } },
      { name: 'b', targets: { jawOpen: 1 }, activations: { nose: 1, chin: 0.5 } },
    ])
    mix.play({ a: 0.5, b: 0.25 })
    expect([...mix.targets]).toEqual([0.5, 0.5])
    expect([...mix.activations].map((value) => Math.round(1e4 * value) / 1e4)).toEqual([0.45, 0.125])
    mix.play({ a: 1, b: 1 })
    expect([...mix.targets]).toEqual([1, 1])
    mix.play({})
    expect([...mix.targets, ...mix.activations]).toEqual([0, 0, 0, 0])
    expect(() => mix.play({ a: 1.5 })).toThrow('weight of "a" out of range, got 1.5, allowed: 0 to 1')
  })

  it('adds to the activation at rest, and keeps other areas at rest', () => {
    const mix = new ExpressionMix(
      [
        { name: 'neutral', targets: {}, activations: { chin: 0 } },
        { name: 'a', targets: {}, activations: { scar: 0.3, nose: 1 } },
        { name: 'b', targets: {}, activations: { scar: 1 } },
      ],
      (area) => (area === 'scar' ? 0.75 : 0),
    )
    const scar = mix.areaNames.indexOf('scar')
    const after = (...choice: Parameters<typeof mix.play>) => {
      mix.play(...choice)
      return mix.activations[scar]!
    }
    expect(mix.activations[scar]).toBe(0.75)
    expect(after('a')).toBeCloseTo(0.3, 6)
    expect(after('neutral')).toBe(0.75)
    expect(after({ b: 0.5 })).toBeCloseTo(0.875, 6)
    expect(after({ a: 1, b: 1 })).toBeCloseTo(0.55, 6)
    expect(after({})).toBe(0.75)
  })

  it.each<[Easing, number, number]>([
    ['linear', 0.25, 0.75],
    ['easeIn', 0.0625, 0.5625],
    ['easeOut', 0.4375, 0.9375],
    ['easeInOut', 0.15625, 0.84375],
    [(share) => share ** 3, 0.015625, 0.421875],
  ])('eases %s', (easing, quarter, threeQuarters) => {
    const mix = new ExpressionMix(two)
    mix.play('wink', 2, easing)
    mix.update(0.5)
    expect(mix.targets[0]).toBeCloseTo(quarter, 6)
    mix.update(1)
    expect(mix.targets[0]).toBeCloseTo(threeQuarters, 6)
    mix.update(5)
    expect(mix.targets[0]).toBe(1)
  })

  it('refuses unknown names', () => {
    const mix = new ExpressionMix(two)
    expect(() => mix.play('wink', -1)).toThrow('duration out of range, got -1, allowed: at least 0 seconds')
    expect(() => new ExpressionMix([])).toThrow('ExpressionMix: no expressions')
  })
})

describe('EXPRESSIONS', () => {
  it('are the documented ones, with neutral first', () => {
    expect(EXPRESSIONS.map(({ name }) => name)).toEqual(
      expect.arrayContaining([
        'neutral',
        'surprised',
        'angry',
        'happy',
        'disgusted',
        'sad',
        'leftBrow',
        'rightBrow',
        'leftWink',
        'rightWink',
      ]),
    )
    expect(EXPRESSIONS[0]).toEqual({ name: 'neutral', targets: {}, activations: {} })
  })

  it.each(EXPRESSIONS.map((expression) => [expression.name, expression] as const))(
    '%s uses names of ARKit and the shipped faces, within 0..1',
    (_, { targets, activations }) => {
      for (const name of Object.keys(targets)) expect(name).toMatch(ARKIT)
      for (const name of Object.keys(activations)) expect(AREAS).toContain(name)
      for (const value of [...Object.values(targets), ...Object.values(activations)]) {
        expect(value).toBeGreaterThan(0)
        expect(value).toBeLessThanOrEqual(1)
      }
    },
  )
})
