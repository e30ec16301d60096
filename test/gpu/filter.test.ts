import type { RgbaImage } from 'furrow'
import { DirectionalLight, MeshStandardMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { mapOf } from './face.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const PIXELS = 32
const MAP = 256

describe.each(RENDERERS)("filtering of the layers' maps on %s", (name) => {
  const harness = harnessOn(name)

  // The cases have 8, 5, or less than 1 texel per pixel. [1, 0.1] gives 8 texels in x and 1 in y, as at a grazing angle.
  it.each([
    [1, [1, 1]],
    [1, [0.6, 0.6]],
    [1, [1, 0.1]],
    [8, [1, 0.1]],
    [8, [1, 1]],
    [1, [0.05, 0.05]],
  ])(
    "equals that of the material's own map, with anisotropy %d, over %j of the map",
    async (anisotropy, part) => {
      const normals = randomNormals(seeded(5), MAP)
      const flat = randomNormals(() => 0.5, MAP)
      const draw = async (base: RgbaImage, layered: RgbaImage | null) => {
        const mesh = square(new MeshStandardMaterial({ normalMap: mapOf(base, anisotropy), roughness: 0.9 }))
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
      const [exact, shown, flatOnly] = [
        await draw(normals, null),
        await draw(flat, normals),
        await draw(flat, null),
      ]
      expect(largestDifference(exact, flatOnly)).toBeGreaterThan(8 / 255)
      expect(largestDifference(exact, shown)).toBeLessThanOrEqual(2 / 255)
    },
  )
})
