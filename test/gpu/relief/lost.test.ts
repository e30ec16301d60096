import type { WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { expect, it } from 'vitest'
import { createHarness, type Harness } from '../harness.ts'
import { ball, heightSet, sceneOf, sideCamera } from './ball.ts'
import { differing, FEW } from './differing.ts'
import { displacedMesh } from './displaced-ball.ts'

const draw = (harness: Harness, mesh = ball()) => harness.renderBytes(sceneOf(mesh), sideCamera(0.15), 256)

/** Creates a ball and draws its relief. */
async function drawnBall(harness: Harness) {
  const mesh = ball()
  const wrinkles = new harness.Wrinkles(mesh, heightSet(), { relief: 'on' })
  await wrinkles.reliefReady()
  await draw(harness, mesh)
  return { mesh, wrinkles, before: await draw(harness, mesh) }
}

it('relief is drawn again after the loss of a WebGL context', async () => {
  const harness = await createHarness('webgl')
  const { mesh, wrinkles, before } = await drawnBall(harness)
  const canvas = harness.renderer.domElement
  const loss = (harness.renderer as WebGLRenderer).getContext().getExtension('WEBGL_lose_context')!
  const once = (event: string) =>
    new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }))
  const [lost, restored] = [once('webglcontextlost'), once('webglcontextrestored')]
  loss.loseContext()
  await lost
  await new Promise((resolve) => setTimeout(resolve, 10))
  loss.restoreContext()
  await restored
  expect(differing(await draw(harness, mesh), before)).toBe(0)
  wrinkles.dispose()
  harness.dispose()
})

it('another renderer draws the relief, still moving, after the loss of a WebGPU device', async () => {
  const harness = await createHarness('webgpu')
  const { mesh, wrinkles, before } = await drawnBall(harness)
  const { device } = (harness.renderer as WebGPURenderer).backend as unknown as {
    device: { destroy(): void; lost: Promise<unknown> }
  }
  device.destroy()
  await device.lost
  const next = await createHarness('webgpu')
  expect(differing(await draw(next, mesh), before)).toBe(0)
  mesh.morphTargetInfluences![0] = 0.7
  expect(differing(await draw(next, mesh), before)).toBeGreaterThan(100)
  expect(differing(await draw(next, mesh), await draw(next, displacedMesh(mesh)))).toBeLessThan(FEW)
  wrinkles.dispose()
  next.dispose()
})
