import { describe, expect, it } from 'vitest'
import { expressionBinds } from '../../../packages/furrow/src/drivers/morph/vrm-binds.ts'

const nodes = [{ mesh: 1 }, { name: 'hips' }, { mesh: 0 }]
const of = (json: unknown, mesh = 0) => Object.fromEntries(expressionBinds(json, mesh))

describe('expressionBinds', () => {
  it('of VRM 1.0 include the nodes with the mesh, for presets and custom expressions', () => {
    const bind = (node: number, index: number, weight?: number) => ({ node, index, weight })
    const expressions = {
      preset: { happy: { morphTargetBinds: [bind(2, 0, 0.5), bind(0, 1, 1), bind(2, 3)] }, neutral: {} },
      custom: { puff: { morphTargetBinds: [bind(2, 1, 1)] }, happy: { morphTargetBinds: [bind(2, 9, 1)] } },
    }
    const json = { nodes, extensions: { VRMC_vrm: { expressions } } }
    expect(of(json)).toEqual({
      happy: [
        { index: 0, weight: 0.5 },
        { index: 3, weight: 1 },
      ],
      neutral: [],
      puff: [{ index: 1, weight: 1 }],
    })
    expect(of(json, 1)).toEqual({ happy: [{ index: 1, weight: 1 }], neutral: [], puff: [] })
  })

  it('of VRM 0 are converted from percent, and presets get the names of VRM 1.0', () => {
    const blendShapeGroups = [
      { name: 'Joy', presetName: 'joy', binds: [{ mesh: 0, index: 2, weight: 25 }] },
      { name: 'Blink_L', presetName: 'blink_l', binds: [{ mesh: 0, index: 0 }] },
      { name: 'Puff', presetName: 'unknown', binds: [{ mesh: 1, index: 0, weight: 100 }] },
      { name: 'Joy again', presetName: 'joy', binds: [{ mesh: 0, index: 1, weight: 100 }] },
    ]
    expect(of({ nodes, extensions: { VRM: { blendShapeMaster: { blendShapeGroups } } } })).toEqual({
      happy: [{ index: 2, weight: 0.25 }],
      blinkLeft: [{ index: 0, weight: 1 }],
      Puff: [],
    })
  })

  const ODD = [undefined, null, 0.5, 'x', [], [null], { a: null }, { length: 1 }]
  it.each(ODD.map((odd) => [JSON.stringify(odd), odd]))('are empty for %s', (_, odd) => {
    const v1 = (expressions: unknown) => ({ nodes, extensions: { VRMC_vrm: { expressions } } })
    const v0 = (groups: unknown) => ({
      extensions: { VRM: { blendShapeMaster: { blendShapeGroups: groups } } },
    })
    const binds = (bind: unknown) => [
      v1({ preset: { happy: { morphTargetBinds: bind } } }),
      v0([{ presetName: 'joy', binds: bind }]),
    ]
    const files = [
      odd,
      { extensions: odd },
      { extensions: { VRMC_vrm: odd, VRM: odd } },
      { extensions: { VRM: { blendShapeMaster: odd } } },
      ...[odd, { preset: odd, custom: odd }, { preset: { happy: odd } }].map(v1),
      ...[odd, [odd], [{ name: odd, presetName: odd }]].map(v0),
      ...[odd, [odd], [{ node: odd, mesh: odd, index: 0 }], [{ node: 2, mesh: 0, index: odd }]].flatMap(
        binds,
      ),
      { ...v1({ preset: { happy: { morphTargetBinds: [{ node: 2, index: 0 }] } } }), nodes: odd },
    ]
    for (const file of files) expect(Object.values(of(file)).flat(), JSON.stringify(file)).toEqual([])
  })

  it('leave out weights that are not numbers', () => {
    const bind = (weight: unknown) => ({ node: 2, index: 0, weight })
    const happy = { morphTargetBinds: [bind({}), bind('x'), bind([1, 2])] }
    expect(of({ nodes, extensions: { VRMC_vrm: { expressions: { preset: { happy } } } } })).toEqual({
      happy: [],
    })
  })
})
