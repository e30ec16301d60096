import type { InputDriver } from 'furrow'
import { curveAt } from 'furrow/internal'
import { addDrivers } from 'furrow/three'
import { addDrivers as addComputedDrivers } from 'furrow/webgpu'
import { MeshStandardMaterial } from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, RENDERERS, square } from './harness.ts'
import { influenceError } from './influence-error.ts'

describe.each(RENDERERS)("an application's inputs on %s", (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  it('activate areas by the curves of their drivers, within 1/255 of the reference', async () => {
    const random = seeded(15)
    const set = randomSet(random, 8, 32)
    const drivers = set.areas.map(
      (area, i): InputDriver => ({
        type: 'input',
        name: `input${i % 3}`,
        area: area.name,
        curve: [
          [-20, random()],
          [10 + 10 * random(), random()],
          [90, random()],
        ],
      }),
    )
    const mesh = square(new MeshStandardMaterial())
    const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 32 })
    ;(name === 'webgl' ? addDrivers : addComputedDrivers)(wrinkles, drivers)
    const values: Record<string, number> = { input0: 37, input1: -5, input2: 0 }
    for (const input of ['input0', 'input1']) wrinkles.inputs.set(input, values[input])
    const activations = drivers.map(({ name, curve }) => curveAt(curve, values[name]))
    const { error, dispose } = await influenceError(harness, mesh, wrinkles, set, activations)
    expect(error).toBeLessThanOrEqual(1 / 255)
    for (const [i, { name }] of set.areas.entries()) {
      expect(wrinkles.getActivation(name)).toBeCloseTo(activations[i], 6)
    }
    dispose()
  })
})
