import { readdirSync, readFileSync } from 'node:fs'
import { type DriverDefinition, parseDrivers, registerDriver, type WrinkleDriver } from 'furrow'
import { DRIVER_TYPES, describeDriver, explain, isKnownDriver, parseWrinkleMaps } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { driven } from '../../driven.ts'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'

const folder = new URL('../../../packages/furrow/src/drivers/', import.meta.url)

describe('the driver registry', () => {
  it('has an entry, and a schema, for every folder in drivers/', () => {
    const folders = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory())
    expect(folders.map(({ name }) => name).sort()).toEqual([...DRIVER_TYPES].sort())
    for (const type of DRIVER_TYPES) {
      const schema = JSON.parse(readFileSync(new URL(`${type}/schema.json`, folder), 'utf8'))
      expect(schema.properties.type.const).toBe(type)
    }
  })

  it('equals the list in the published schema', () => {
    const path = new URL('../../../docs/schema/', import.meta.url)
    const { allOf } = JSON.parse(
      readFileSync(new URL('FURROW_wrinkle_maps.driver.schema.json', path), 'utf8'),
    )
    expect(allOf).toEqual(
      DRIVER_TYPES.map((type) => ({
        if: { properties: { type: { const: type } } },
        // biome-ignore lint/suspicious/noThenProperty: a keyword of JSON Schema
        then: { $ref: `FURROW_wrinkle_maps.driver.${type}.schema.json` },
      })),
    )
    for (const type of DRIVER_TYPES) {
      const published = readFileSync(new URL(`FURROW_wrinkle_maps.driver.${type}.schema.json`, path), 'utf8')
      expect(JSON.parse(published)).toEqual(
        JSON.parse(readFileSync(new URL(`${type}/schema.json`, folder), 'utf8')),
      )
    }
  })
})

interface BreathDriver {
  type: 'breath'
  area: string
  depth: number
}

/** Custom driver type, which combines two inputs of the application. */
const breath: DriverDefinition<BreathDriver> = {
  type: 'breath',
  read: (fields) => ({ area: fields.area(), depth: fields.number('depth', 0, 1, 0.5) }),
  activate: ({ area, depth }) => ({
    area,
    links: ['phase', 'effort'].map((name) => ({ input: { kind: 'value', name }, weight: 1 })),
    rule: ([phase, effort]) => depth * effort * (0.5 - 0.5 * Math.cos(2 * Math.PI * phase)),
    curve: STRAIGHT,
  }),
}

it.each<[WrinkleDriver, string]>([
  [
    morph('nose', [link('noseSneerLeft', 0.5), link('noseSneerRight', 1, ramp(0.1, 1, 2))], {
      rule: 'max',
      curve: ramp(0, 0.8),
    }),
    'nose = max(0.5 noseSneerLeft, noseSneerRight [(0.1, 0) (1, 2)]), curve (0, 0) (0.8, 1)',
  ],
  [
    morph('nose', [link('cheekPuff', -0.5), link('noseSneer'), link('jawOpen', -0.25)]),
    'nose = -0.5 cheekPuff + noseSneer - 0.25 jawOpen',
  ],
  [
    {
      type: 'bone',
      area: 'neck',
      joints: ['chest', 'head'],
      measure: 'angle',
      axis: [0, 1, 0],
      curve: STRAIGHT,
    },
    'neck = angle of joint head from chest about 0 1 0',
  ],
  [{ type: 'age', area: 'nose', curve: ramp(20, 80) }, 'nose = input age, curve (20, 0) (80, 1)'],
  [{ type: 'conflict', targets: ['browDown', 'browUp'] }, 'conflict: browDown and browUp cancel each other'],
  [{ type: 'time', area: 'nose', attack: 0.1, release: 0.4 }, 'time: nose rises in 0.1 s, falls in 0.4 s'],
  [
    { type: 'expression', name: 'joy', targets: [{ name: 'mouthSmile', weight: 0.8 }], activations: [] },
    'expression joy: 0.8 mouthSmile',
  ],
  [
    {
      type: 'expression',
      name: 'rage',
      targets: [link('browDown'), link('jawOpen', 0.25)],
      activations: [
        { area: 'glabella', activation: 1 },
        { area: 'nose', activation: 0.35 },
      ],
    },
    'expression rage: browDown, 0.25 jawOpen, area glabella, 0.35 area nose',
  ],
  [
    { type: 'expression', name: 'neutral', targets: [], activations: [] },
    'expression neutral: the face at rest',
  ],
])('describes %j', (driver, text) => expect(describeDriver(driver)).toBe(text))

describe('registerDriver', () => {
  const json = { type: 'breath', area: 'nose', effort: 3 }

  it('keeps drivers of an unknown type, and evaluates them once the type is registered', () => {
    const [unknown] = parseDrivers([json], ['nose'])
    expect(unknown).toEqual(json)
    expect(isKnownDriver(unknown)).toBe(false)
    expect(describeDriver(unknown)).toContain('breath: unknown type')
    expect(driven([unknown]).plan.unknownTypes).toEqual(['breath'])

    registerDriver(breath)
    const [known] = parseDrivers([json], ['nose'])
    expect(known).toEqual({ type: 'breath', area: 'nose', depth: 0.5 })
    expect(describeDriver(known)).toBe('nose = breath(input phase, input effort)')
    const { activations, plan } = driven([known])
    expect(plan.unknownTypes).toEqual([])
    const { nose } = activations({ inputs: { phase: 0.5, effort: 0.8 } })
    expect(nose).toBeCloseTo(0.4, 6)
    const [why] = explain([known], [{ name: 'nose' }], {
      targetNames: [],
      weights: [],
      inputs: { phase: 0.5, effort: 0.8 },
    })
    expect(why.activation).toBeCloseTo(0.4, 6)
    expect(why.parts[0].links.map(({ link, value }) => [link.name, value])).toEqual([
      ['phase', 0.5],
      ['effort', 0.8],
    ])
  })

  it("checks the type's fields, and files contain its drivers", () => {
    const texture = { index: 0 }
    const maps = (driver: WrinkleDriver) =>
      parseWrinkleMaps({
        layers: [{ name: 'skin', normalTexture: texture }],
        areas: [{ name: 'nose', texture }],
        drivers: [driver],
      })
    expect(maps({ ...json, depth: 0.2 }).drivers).toEqual([{ type: 'breath', area: 'nose', depth: 0.2 }])
    expect(() => maps({ ...json, depth: 7 })).toThrow('drivers[0].depth is out of range, got 7')
    expect(() => maps({ ...json, area: 'tail' })).toThrow('drivers[0].area is unknown')
  })

  it('refuses an existing type', () => {
    expect(() => registerDriver({ ...breath, type: 'morph' as never })).toThrow(
      'registerDriver: the driver type already exists, got "morph"',
    )
    expect(() => registerDriver(breath)).toThrow('the driver type already exists, got "breath"')
  })
})
