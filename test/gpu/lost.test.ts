import { DirectionalLight, MeshPhysicalMaterial, Scene, type WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, square, squareCamera } from './harness.ts'

function wrinkledScene(harness: Harness) {
  const mesh = square(new MeshPhysicalMaterial())
  const scene = new Scene()
  const light = new DirectionalLight()
  light.position.set(1, 1, 1)
  scene.add(mesh, light)
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8, 16), { areaSize: 8 })
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.4)
  return { scene, wrinkles }
}

describe('after a loss of the graphics device', () => {
  it('wrinkles remain when a WebGL context is restored', async () => {
    const harness = await createHarness('webgl')
    const { scene, wrinkles } = wrinkledScene(harness)
    const before = await harness.renderBytes(scene, squareCamera(), 32)
    const canvas = harness.renderer.domElement
    const loss = (harness.renderer as WebGLRenderer).getContext().getExtension('WEBGL_lose_context')!
    const once = (event: string) =>
      new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }))
    const lost = once('webglcontextlost')
    loss.loseContext()
    await lost
    const restored = once('webglcontextrestored')
    await new Promise((resolve) => setTimeout(resolve, 10))
    loss.restoreContext()
    await restored
    expect([...(await harness.renderBytes(scene, squareCamera(), 32))]).toEqual([...before])
    wrinkles.setActivation('area0', 1)
    expect([...(await harness.renderBytes(scene, squareCamera(), 32))]).not.toEqual([...before])
    harness.dispose()
  })

  it('wrinkles remain when the page creates another renderer on WebGPU', async () => {
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
