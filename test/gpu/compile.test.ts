import {
  AmbientLight,
  DirectionalLight,
  type Mesh,
  MeshPhysicalMaterial,
  RenderTarget,
  Scene,
  type WebGLRenderer,
} from 'three'
import { describe, expect, inject, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const SIZE = 32
const isOnOldest = inject('threeRelease') === 'oldest'

describe.each(RENDERERS)('compileAsync on %s', (name) => {
  const harness = harnessOn(name)

  it('compiles all programs of the first frame with wrinkles, and that frame is complete', async () => {
    const renderer = harness.renderer as WebGLRenderer
    const face = () => {
      const mesh = square(new MeshPhysicalMaterial())
      const scene = new Scene().add(mesh, new DirectionalLight(), new AmbientLight())
      const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 6, 16), { areaSize: 16 })
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.5)
      return { scene, wrinkles }
    }
    const { scene, wrinkles } = face()
    const target = new RenderTarget(SIZE, SIZE)
    renderer.setRenderTarget(target as never)
    const none = harness.programs()
    await renderer.compileAsync(scene, squareCamera())
    const programs = harness.programs()
    expect(programs).toBeGreaterThan(none + 1)
    renderer.render(scene, squareCamera())
    renderer.setRenderTarget(null)
    // The oldest supported `WebGPURenderer` compiles the programs of the influence map only in the frame.
    if (!isOnOldest || name === 'webgl') expect(harness.programs()).toBe(programs)
    const shown = (await harness.renderBytes(scene, squareCamera(), SIZE)).join()
    wrinkles.dispose()
    const fresh = face()
    expect(shown).toBe((await harness.renderBytes(fresh.scene, squareCamera(), SIZE)).join())
    fresh.wrinkles.dispose()
    target.dispose()
  })
})

it.each(RENDERERS)('compileAsync works long after the last frame, on %s', async (name) => {
  const harness = await createHarness(name)
  const renderer = harness.renderer as WebGLRenderer
  // A renderer counts the frames of the page, and drops objects that it has not drawn for ten frames.
  for (let frame = 0; frame < 15; frame++) await new Promise(requestAnimationFrame)
  const face = (z: number) => {
    const mesh = square(new MeshPhysicalMaterial())
    mesh.position.z = z
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 6, 16), { areaSize: 16 })
    wrinkles.setActivation('area0', 1)
    return mesh
  }
  const scene = new Scene().add(face(0), face(-1), new DirectionalLight())
  await renderer.compileAsync(scene, squareCamera())
  const shown = (await harness.renderBytes(scene, squareCamera(), SIZE)).join()
  const again = new Scene().add(face(0), new DirectionalLight())
  expect((await harness.renderBytes(again, squareCamera(), SIZE)).join()).toBe(shown)
  harness.dispose()
})

it('influence programs are compiled in a first frame without wrinkles, on webgl', async () => {
  const harness = await createHarness('webgl')
  const scene = new Scene().add(square(new MeshPhysicalMaterial()), new DirectionalLight())
  const wrinkles = new harness.Wrinkles(scene.children[0] as Mesh, randomSet(seeded(3), 6, 16), {
    areaSize: 16,
  })
  await harness.render(scene, squareCamera(), SIZE)
  const programs = harness.programs()
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.5)
  await harness.render(scene, squareCamera(), SIZE)
  expect(harness.programs()).toBe(programs)
  wrinkles.dispose()
  harness.dispose()
})
