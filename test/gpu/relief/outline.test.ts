import type { Mesh } from 'three'
import { describe, expect, it } from 'vitest'
import { harnessOn, RENDERERS } from '../harness.ts'
import { ball, heightSet, sceneOf, sideCamera } from './ball.ts'
import { displacedBall } from './displaced-ball.ts'
import { distances, fractionWithin, type Outline, outlineOf, projectedOutline } from './outline.ts'

/** Width of the drawn picture. Distances are in pixels of a picture half as wide. */
const FINE = 3200
const PIXEL = FINE / 1600
const SIDE = 0.15

describe.each(RENDERERS)('relief on %s', (name) => {
  const harness = harnessOn(name)

  it('has the outline of the reference', async () => {
    const mesh = ball()
    mesh.morphTargetInfluences![0] = 0.5
    const wrinkles = new harness.Wrinkles(mesh, heightSet(), { relief: 'on' })
    const [scene, camera] = [sceneOf(mesh), sideCamera(SIDE)]
    const picture = async () => outlineOf(await harness.renderBytes(scene, camera, FINE), FINE, FINE)
    await picture()
    wrinkles.relief = 'off'
    const plain = await picture()
    wrinkles.relief = 'on'
    await wrinkles.reliefReady()
    const shown = await picture()
    const expected = referenceOutline(mesh)
    expect(fractionWithin(1.5 * PIXEL, distances(plain, expected))).toBeLessThan(0.5)
    expect(fractionWithin(0.5 * PIXEL, distances(shown, expected))).toBeGreaterThan(0.995)
    wrinkles.dispose()
  })
})

function referenceOutline(mesh: Mesh): Outline {
  const { triangles, positions } = displacedBall(mesh)
  const toPixels = (value: number) => (value / SIDE + 0.5) * FINE
  return projectedOutline(
    triangles,
    (vertex) => [toPixels(positions[3 * vertex]), toPixels(positions[3 * vertex + 1])],
    FINE,
  )
}
