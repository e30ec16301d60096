import { MToonMaterial } from '@pixiv/three-vrm-materials-mtoon'
import { AmbientLight, Color, type Material, type Mesh } from 'three'
import { expect, it, vi } from 'vitest'
import { createHarness } from '../harness.ts'
import { ball, heightSet, sceneOf, sideCamera } from './ball.ts'
import { differing, FEW } from './differing.ts'
import { displacedMesh } from './displaced-ball.ts'

const white = { color: new Color(1, 1, 1), shadeColorFactor: new Color(1, 1, 1) }

it.each([
  ['', false],
  [', whose second material is its outline', true],
])('an MToon face has relief%s', async (_, hasOutline) => {
  const warn = vi.spyOn(console, 'warn')
  const harness = await createHarness('webgl')
  const mesh = ball() as Mesh<Mesh['geometry'], Material | Material[]>
  const mtoon = new MToonMaterial(white as never)
  mesh.material = mtoon
  if (hasOutline) {
    mesh.material = [mtoon, new MToonMaterial({ ...white, isOutline: true } as never)]
    const { count } = mesh.geometry.index!
    mesh.geometry.addGroup(0, count, 0)
    mesh.geometry.addGroup(0, count, 1)
  }
  const scene = sceneOf(mesh as Mesh).add(new AmbientLight(0xffffff, 5))
  const picture = async () => {
    for (let i = 0; i < 3; i++) await harness.renderBytes(scene, sideCamera(0.15), 256)
    return silhouette(await harness.renderBytes(scene, sideCamera(0.15), 256))
  }
  const plain = await picture()
  const wrinkles = new harness.Wrinkles(mesh as Mesh, heightSet(), { relief: 'on' })
  await wrinkles.reliefReady()
  const shown = await picture()
  const expected = silhouette(
    await harness.renderBytes(sceneOf(displacedMesh(ball())), sideCamera(0.15), 256),
  )
  expect(wrinkles.mode).toBe('default')
  // An outline of no width is drawn round the mesh as it is: it fills the valleys.
  if (!hasOutline) expect(differing(shown, expected)).toBeLessThan(FEW)
  expect(differing(shown, plain)).toBeGreaterThan(100)
  wrinkles.dispose()
  expect(differing(await picture(), plain)).toBe(0)
  expect(warn.mock.calls.filter(([text]) => /^Wrinkles/.test(text))).toEqual([])
  harness.dispose()
})

/** White wherever anything is drawn. */
function silhouette(pixels: Uint8Array): Uint8Array {
  return pixels.map((_, i) => (pixels[i - (i % 4) + 1] > 8 ? 255 : 0))
}
