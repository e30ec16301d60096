import { updateArea, updateLayer } from 'furrow/three'
import { DirectionalLight, MeshPhysicalMaterial, Scene } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { describe, expect, it } from 'vitest'
import { randomAreas, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, square, squareCamera } from './harness.ts'
import { loseContext } from './lose-context.ts'

function wrinkledScene(harness: Harness, set = randomSet(seeded(4), 6, 8, 16)) {
  const mesh = square(new MeshPhysicalMaterial())
  const scene = new Scene()
  const light = new DirectionalLight()
  light.position.set(1, 1, 1)
  scene.add(mesh, light)
  const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 8 })
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.4)
  return { scene, wrinkles }
}

describe('after a loss of the graphics device', () => {
  it('keeps wrinkles when a WebGL context is restored', async () => {
    const harness = await createHarness('webgl')
    const { scene, wrinkles } = wrinkledScene(harness)
    const before = await harness.renderBytes(scene, squareCamera(), 32)
    await loseContext(harness, () => {})
    expect([...(await harness.renderBytes(scene, squareCamera(), 32))]).toEqual([...before])
    wrinkles.setActivation('area0', 1)
    expect([...(await harness.renderBytes(scene, squareCamera(), 32))]).not.toEqual([...before])
    harness.dispose()
  })

  it('shows changes made before, during and after the loss of a WebGL context', async () => {
    const harness = await createHarness('webgl')
    const random = seeded(5)
    const set = randomSet(random, 6, 8, 16)
    const { scene, wrinkles } = wrinkledScene(harness, set)
    await harness.renderBytes(scene, squareCamera(), 32)
    const change = (name: string) => {
      const area = set.areas.find((own) => own.name === name)!
      area.weights = randomAreas(random, 1, 8)[0].weights
      updateArea(wrinkles, name, area.weights)
      set.layers[0].normal = randomNormals(random, 16)
      updateLayer(wrinkles, 'skin', { normal: set.layers[0].normal })
    }
    change('area0')
    await loseContext(harness, () => change('area1'))
    const expectFresh = async () => {
      const shown = await harness.renderBytes(scene, squareCamera(), 32)
      const fresh = wrinkledScene(harness, set)
      const wanted = await harness.renderBytes(fresh.scene, squareCamera(), 32)
      fresh.wrinkles.dispose()
      expect(largestDifference(shown, wanted)).toBeLessThanOrEqual(1)
    }
    await expectFresh()
    change('area2')
    await expectFresh()
    harness.dispose()
  })

  it('keeps wrinkles when the page creates another renderer on WebGPU', async () => {
    const harness = await createHarness('webgpu')
    const { scene, wrinkles } = wrinkledScene(harness)
    const before = await harness.renderBytes(scene, squareCamera(), 32)
    const { device } = (harness.renderer as WebGPURenderer).backend as unknown as {
      device: { destroy(): void; lost: Promise<unknown> }
    }
    device.destroy()
    await device.lost
    const next = await createHarness('webgpu')
    expect([...(await next.renderBytes(scene, squareCamera(), 32))]).toEqual([...before])
    wrinkles.setActivation('area0', 1)
    expect([...(await next.renderBytes(scene, squareCamera(), 32))]).not.toEqual([...before])
    next.dispose()
  })
})
