import type { RgbaImage } from 'furrow'
import { DirectionalLight, MeshStandardMaterial, Scene } from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { layer, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { mapOf } from './face.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'

const PIXELS = 32
const MAP = 256

describe.each(RENDERERS)("the layers' maps seen from afar on %s", (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  // Texels per pixel across and down: 8 and 8, 5 and 5, aslant as 8 and 1, and magnified.
  it.each([
    [1, [1, 1]],
    [1, [0.6, 0.6]],
    [1, [1, 0.1]],
    [8, [1, 0.1]],
    [8, [1, 1]],
    [1, [0.05, 0.05]],
  ])(
    "are filtered as the material's own is, with anisotropy %d, over %j of the map",
    async (anisotropy, part) => {
      const normals = randomNormals(seeded(5), MAP)
      const flat = randomNormals(() => 0.5, MAP)
      const show = async (own: RgbaImage, layered: RgbaImage | null) => {
        const mesh = square(new MeshStandardMaterial({ normalMap: mapOf(own, anisotropy), roughness: 0.9 }))
        const { uv } = mesh.geometry.attributes
        for (let i = 0; i < uv.count; i++) uv.setXY(i, uv.getX(i) * part[0], uv.getY(i) * part[1])
        const scene = new Scene()
        const light = new DirectionalLight(0xffffff, 3)
        light.position.set(1, 0.6, 1)
        scene.add(mesh, light)
        if (!layered) return harness.render(scene, squareCamera(), PIXELS)
        const full = { width: 8, height: 8, data: new Uint8Array(64).fill(255) }
        const set = { layers: [layer('all', 'replace', layered)], areas: [{ name: 'all', weights: full }] }
        const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 8 })
        wrinkles.setActivation('all', 1)
        const shown = await harness.render(scene, squareCamera(), PIXELS)
        wrinkles.dispose()
        return shown
      }
      const [exact, shown, bare] = [
        await show(normals, null),
        await show(flat, normals),
        await show(flat, null),
      ]
      expect(largest(exact, bare)).toBeGreaterThan(8 / 255)
      expect(largest(exact, shown)).toBeLessThanOrEqual(2 / 255)
    },
  )
})

function largest(a: Float32Array, b: Float32Array): number {
  return a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0)
}
