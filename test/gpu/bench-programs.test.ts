import { DirectionalLight, type Material, MeshPhysicalMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { giveDistinctProgram } from '../../bench/page/distinct-program.ts'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn, square, squareCamera } from './harness.ts'

describe.each(['webgl', 'webgpu'] as const)('programs of the benchmark on %s', (name) => {
  const harness = harnessOn(name)

  it.each(['off', 'default', 'composed', 'paper'] as const)(
    'are not shared with other copies, and draw the same: %s',
    async (mode) => {
      const set = randomSet(seeded(7), 1, 8)
      const draw = async (isOwn: boolean) => {
        const mesh = square(new MeshPhysicalMaterial())
        if (isOwn) giveDistinctProgram(mesh.material as Material, name)
        const wrinkles = new harness.Wrinkles(mesh, set, { mode, areaSize: 8 })
        for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.7)
        const scene = new Scene()
        scene.add(mesh, new DirectionalLight())
        const pixels = await harness.renderBytes(scene, squareCamera(), 16)
        return { pixels: pixels.join(), programs: harness.programs() }
      }
      const shared = [await draw(false), await draw(false)]
      const own = [await draw(true), await draw(true)]
      expect(shared[1].programs).toBe(shared[0].programs)
      // WebGPURenderer numbers nodes per material copy, so each copy has another vertex shader.
      expect(own[0].programs).toBeGreaterThan(shared[1].programs)
      expect(own[1].programs).toBe(own[0].programs + 1)
      for (const { pixels } of own) expect(pixels).toBe(shared[0].pixels)
    },
  )
})
