import type { MorphDriver, WrinkleDriver } from 'furrow'
import { planDrivers, targetSource } from 'furrow/internal'
import { afterEach, beforeEach, describe, expect, it, type MockInstance, vi } from 'vitest'
import { AtlasCells } from '../../../packages/furrow/src/runtime/atlas-cells.ts'
import { DriverRuntime } from '../../../packages/furrow/src/runtime/driver-runtime.ts'
import { Face } from '../../../packages/furrow/src/runtime/face.ts'
import { LastInputs } from '../../../packages/furrow/src/runtime/last-inputs.ts'
import { NamedInputs } from '../../../packages/furrow/src/runtime/named-inputs.ts'
import { morph, STRAIGHT } from '../../drivers.ts'

const NAMES = ['browInnerUp', 'jawOpen']
const AREAS = [{ name: 'brow' }, { name: 'chin' }]
const FACES = 3

const DRIVERS = [morph('brow', 'browInnerUp')]

const slotsOf = (count: number) =>
  ({ slots: Array.from({ length: count }), version: 0 }) as unknown as Face['slots']

let weights: number[][]
let evaluated: MockInstance
beforeEach(() => {
  weights = Array.from({ length: FACES }, (_, i) => [0.25 * i, 0.5])
  evaluated = vi.spyOn(LastInputs.prototype, 'settle')
})
afterEach(() => vi.restoreAllMocks())

const read = (values: Float64Array, instance: number) => values.set(weights[instance])

function runtimeOf(drivers: readonly WrinkleDriver[], inputs = new NamedInputs(FACES, () => {})) {
  const plan = planDrivers(drivers)
  const target = { ...targetSource(plan.inputs.target, NAMES), read }
  return new DriverRuntime(plan, () => ({ target }), inputs, FACES, 'face')
}

function makeFaces() {
  const slots = slotsOf(AREAS.length)
  return Array.from({ length: FACES }, () => new Face(slots, AREAS))
}

/** Runs a frame. Returns the activation of the first area of each face, and the number of faces whose drivers were evaluated. */
function run(drivers: DriverRuntime<unknown>, faces: readonly Face[], clock = { now: () => 0 }) {
  evaluated.mockClear()
  drivers.readInputs(faces, clock, null)
  drivers.evaluate(faces)
  drivers.apply(faces)
  return {
    brows: faces.map(({ activations }) => activations.get('brow')),
    count: evaluated.mock.calls.length,
  }
}

describe('drivers of blendshapes', () => {
  it('are evaluated only for faces whose blendshapes have moved', () => {
    const [drivers, faces] = [runtimeOf(DRIVERS), makeFaces()]
    expect(run(drivers, faces)).toEqual({ brows: [0, 0.25, 0.5], count: FACES })
    expect(run(drivers, faces)).toEqual({ brows: [0, 0.25, 0.5], count: 0 })
    weights[1][0] = 1
    expect(run(drivers, faces)).toEqual({ brows: [0, 1, 0.5], count: 1 })
    expect(run(drivers, faces).count).toBe(0)
  })

  it('are evaluated if the application changes activations or areas', () => {
    const [drivers, faces] = [runtimeOf(DRIVERS), makeFaces()]
    run(drivers, faces)
    // An activation that the application sets lasts until the next frame.
    faces[2].activations.set('brow', 0.125)
    expect(run(drivers, faces)).toEqual({ brows: [0, 0.25, 0.5], count: 1 })
    faces[0].setResting('brow', 0.125)
    expect(run(drivers, faces)).toEqual({ brows: [0.125, 0.25, 0.5], count: 1 })
    const slots = slotsOf(1)
    for (const face of faces) face.rebind(slots, [{ name: 'brow' }])
    expect(run(drivers, faces)).toEqual({ brows: [0.125, 0.25, 0.5], count: FACES })
    expect(run(drivers, faces).count).toBe(0)
  })
})

it('drivers follow areas that change their position', () => {
  const drivers = runtimeOf([...DRIVERS, morph('chin', 'jawOpen')])
  const faces = makeFaces()
  run(drivers, faces)
  const slots = slotsOf(3)
  for (const face of faces)
    face.rebind(
      slots,
      ['nose', 'chin', 'brow'].map((name) => ({ name })),
    )
  expect(run(drivers, faces).brows).toEqual([0, 0.25, 0.5])
  expect(faces.map(({ activations }) => activations.get('chin'))).toEqual([0.5, 0.5, 0.5])
  expect(faces.map(({ activations }) => activations.get('nose'))).toEqual([0, 0, 0])
})

describe('drivers with inputs and delays', () => {
  it('are evaluated for faces whose inputs the application changes', () => {
    const inputs = new NamedInputs(FACES, () => {})
    const curve: MorphDriver['curve'] = STRAIGHT
    const [drivers, faces] = [
      runtimeOf([{ type: 'input', name: 'stress', area: 'brow', curve }], inputs),
      makeFaces(),
    ]
    run(drivers, faces)
    inputs.set('stress', 0.75, 1)
    expect(run(drivers, faces)).toEqual({ brows: [0, 0.75, 0], count: 1 })
    expect(run(drivers, faces).count).toBe(0)
  })

  it('are evaluated until all delays have ended, also after the clock was stopped for a while', () => {
    const drivers = runtimeOf([...DRIVERS, { type: 'time', area: 'brow', attack: 0.1, release: 0.1 }])
    const faces = makeFaces()
    let milliseconds = 0
    const frame = (step: number) => {
      milliseconds += step
      return run(drivers, faces, { now: () => milliseconds })
    }
    frame(16)
    expect(frame(16).count).toBe(0)
    weights[0][0] = 1
    expect(frame(50).brows[0]).toBeCloseTo(1 - Math.exp(-0.5), 5)
    for (let i = 0; i < 3; i++) expect(frame(0).count).toBe(1)
    expect(frame(50).brows[0]).toBeCloseTo(1 - Math.exp(-1), 5)
    for (let i = 0; i < 100; i++) frame(50)
    expect(frame(50)).toEqual({ brows: [1, 0.25, 0.5], count: 0 })
  })
})

describe('cells of still faces', () => {
  it('are redrawn when small changes have added up', () => {
    const [face] = makeFaces()
    face.activations.set('brow', 0.5)
    const cells = new AtlasCells(8, 8)
    const added = cells.add([face])
    const draw = () => {
      cells.changes = 0
      cells.collect(added)
      if (cells.changes === 0) return false
      added[0].drawn.set(face.activations.values)
      Object.assign(added[0], { version: face.slots.version })
      return true
    }
    expect([draw(), draw(), draw()]).toEqual([true, false, false])
    const moved = [0.501, 0.5015, 0.503].map((value) => {
      face.activations.set('brow', value)
      return draw()
    })
    expect(moved).toEqual([false, false, true])
    // Runs a frame in which the cell is not drawn.
    face.activations.set('brow', 0.25)
    cells.changes = 0
    cells.collect(added)
    expect([draw(), draw()]).toEqual([true, false])
  })
})
