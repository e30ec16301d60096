import { type Mesh, Plane, type Scene, Vector3, type WebGLRenderer } from 'three'
import { ClippingGroup } from 'three/webgpu'
import { expect, it } from 'vitest'
import { createHarness, RENDERERS } from '../harness.ts'
import { ball, heightSet, sceneOf, sideCamera } from './ball.ts'
import { differing, FEW } from './differing.ts'
import { displacedMesh } from './displaced-ball.ts'

const SIZE = 256
const PLANE = new Plane(new Vector3(1, 0.6, 0.2).normalize(), 0.004)

it.each(RENDERERS)('a clipping plane cuts the relief, on %s', async (name) => {
  const harness = await createHarness(name)
  const clipped = (mesh: Mesh): Scene => {
    if (name === 'webgl') {
      ;(harness.renderer as WebGLRenderer).clippingPlanes = [PLANE]
      return sceneOf(mesh)
    }
    const group = new ClippingGroup()
    group.clippingPlanes = [PLANE]
    return sceneOf(group.add(mesh) as never)
  }
  const mesh = ball()
  const wrinkles = new harness.Wrinkles(mesh, heightSet(), { relief: 'on' })
  await wrinkles.reliefReady()
  const picture = (scene: Scene) => harness.renderBytes(scene, sideCamera(0.15), SIZE)
  const scene = clipped(mesh)
  await picture(scene)
  const shown = await picture(scene)
  const expected = await picture(clipped(displacedMesh(mesh)))
  wrinkles.relief = 'off'
  const plain = await picture(scene)
  const lit = expected.filter((value, i) => i % 4 === 1 && value > 8).length
  expect(lit / SIZE ** 2).toBeGreaterThan(0.1)
  expect(lit / SIZE ** 2).toBeLessThan(0.25)
  expect(differing(shown, expected)).toBeLessThan(FEW)
  expect(differing(plain, expected)).toBeGreaterThan(100)
  wrinkles.dispose()
  harness.dispose()
})
