import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { interpolate } from '../../../packages/furrow/src/core/reference.ts'
import { displace } from '../../../packages/furrow/src/relief/displaced.ts'
import { outwardRoom } from '../../../packages/furrow/src/relief/outward-room.ts'
import { splitMesh } from '../../../packages/furrow/src/relief/split-mesh.ts'
import { createHarness, type Harness, RENDERERS } from '../harness.ts'
import { AMPLITUDE, ball, heightBytes, heightSet, sceneOf, sideCamera } from './ball.ts'
import { distances, fractionWithin, outlineOf, projectedOutline } from './outline.ts'

/** Pixels of a picture, and of those in which distances are given: outlines are drawn twice as fine. */
const FINE = 3200
const PIXEL = FINE / 1600
const SIDE = 0.15

describe.each(RENDERERS)('%s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  it('heights move the outline to where the reference has it', async () => {
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

function referenceOutline(mesh: ReturnType<typeof ball>) {
  const { attributes, index, morphAttributes } = mesh.geometry
  const rest = attributes.position.array as Float32Array
  const coarse = { positions: rest, uvs: attributes.uv.array, triangles: index!.array }
  const steps = splitMesh(coarse, new Uint8Array(index!.count / 3).fill(1))
  let step = steps.next()
  while (!step.done) step = steps.next()
  const dense = step.value
  const { firstOf } = dense
  const normals = attributes.normal.array
  const room = outwardRoom(coarse, normals, firstOf, AMPLITUDE / 2)
  const offsets = morphAttributes.position![0].array
  const positions = Float64Array.from(rest, (value, i) => value + mesh.morphTargetInfluences![0] * offsets[i])
  const bytes = heightBytes()
  const size = Math.sqrt(bytes.length)
  const heightAt = (u: number, v: number) =>
    (interpolate({ width: size, height: size }, u, v, (i, j) => bytes[i + j * size]) / 255 - 0.5) * AMPLITUDE
  const out = displace(dense, { positions, normals }, heightAt, room)
  const toPixels = (value: number) => (value / SIDE + 0.5) * FINE
  return projectedOutline(dense.triangles, (i) => [toPixels(out[3 * i]), toPixels(out[3 * i + 1])], FINE)
}
