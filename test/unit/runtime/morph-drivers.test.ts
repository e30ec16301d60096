import type { MorphDriver } from 'furrow'
import { describe, expect, it, vi } from 'vitest'
import { planDrivers } from '../../../packages/furrow/src/drivers/plan-drivers.ts'
import { targetSource } from '../../../packages/furrow/src/drivers/sources.ts'
import { DriverRuntime } from '../../../packages/furrow/src/runtime/driver-runtime.ts'
import { Face } from '../../../packages/furrow/src/runtime/face.ts'
import type { FaceDrivers } from '../../../packages/furrow/src/runtime/face-drivers.ts'
import { MorphDrivers } from '../../../packages/furrow/src/runtime/morph-drivers.ts'
import { NamedInputs } from '../../../packages/furrow/src/runtime/named-inputs.ts'

const NAMES = ['browInnerUp', 'browDownLeft', 'jawOpen']
const AREAS = [{ name: 'a', activation: 0.1 }, { name: 'b' }, { name: 'c' }]
const CURVE: MorphDriver['curve'] = [
  [0, 0],
  [0.5, 0.2],
  [1, 1],
]
const morph = (area: string, ...targets: MorphDriver['targets']): MorphDriver => ({
  type: 'morph',
  area,
  targets,
  rule: 'sum',
  curve: CURVE,
})

const DRIVERS = [
  morph('a', { name: 'browInnerUp', weight: 0.7 }, { name: 'jawOpen', weight: -0.2 }),
  morph('a', { name: 'browDownLeft', weight: 1 }, { name: 'jawOpen', weight: 0.5 }),
  morph('b', { name: 'browInnerUp', weight: 1 }, { name: 'browDownLeft', weight: 1 }),
]

const slots = (version: number) => ({ slots: [], version }) as unknown as Face['slots']

/** Two faces, the second one with other weights. */
function makeFaces() {
  const own = slots(0)
  return [new Face(own, AREAS), new Face(own, AREAS)]
}

function read(values: Float64Array, instance: number): void {
  values.set(instance === 0 ? [0.9, 0.3, 0.4] : [0.2, Number.NaN, 1])
}

function run(drivers: FaceDrivers<unknown>, faces: readonly Face[]): number[][] {
  drivers.readInputs(faces, performance, null)
  drivers.evaluate(faces)
  drivers.apply(faces)
  return faces.map(({ activations }) => [...activations.values.subarray(0, AREAS.length)])
}

describe('drivers of blendshapes by their very names', () => {
  it('give what drivers of any type give', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const plan = planDrivers(DRIVERS)
    const target = { ...targetSource(plan.inputs.target, NAMES), read }
    const expected = new DriverRuntime(plan, () => ({ target }), new NamedInputs(2, () => {}), 2, 'face')
    const onOther = vi.fn()
    const own = new MorphDrivers(DRIVERS, NAMES, read, onOther)
    const [left, right] = [makeFaces(), makeFaces()]
    for (let frame = 0; frame < 2; frame++) expect(run(own, left)).toEqual(run(expected, right))
    expect(left[0].activations.get('a')).toBeGreaterThan(0.3)
    expect(left[1].activations.get('a')).toBeGreaterThan(0.1)
    expect(own.movedAreas).toEqual(expected.movedAreas)
    // The weight that is NaN.
    expect(warn).toHaveBeenCalledOnce()
    expect(onOther).toHaveBeenCalledOnce()
    warn.mockRestore()
  })

  it('follow areas that change, and say when one of theirs is gone', () => {
    const onOther = vi.fn()
    const own = new MorphDrivers(DRIVERS, NAMES, (weights) => read(weights, 0), onOther)
    const [face] = makeFaces()
    const [[, before]] = run(own, [face])
    face.rebind(slots(1), [{ name: 'c' }, { name: 'b' }, { name: 'a' }])
    const [[, moved, a]] = run(own, [face])
    expect(moved).toBe(before)
    expect(a).toBeGreaterThan(0.3)
    expect(onOther).not.toHaveBeenCalled()
    face.rebind(slots(2), [{ name: 'b' }])
    expect(run(own, [face])[0]).toEqual([before, 0, 0])
    expect(onOther).toHaveBeenCalledOnce()
  })
})
