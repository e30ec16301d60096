import {
  AmbientLight,
  DirectionalLight,
  type Material,
  MeshPhysicalMaterial,
  RenderTarget,
  Scene,
  type WebGLRenderer,
} from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomAreas, randomImage, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference, ROUNDING } from './difference.ts'
import { mapOf } from './face.ts'
import { createHarness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const SIZE = 64

describe.each(RENDERERS)('a face that is alone in its influence map, on %s', (name) => {
  const harness = harnessOn(name)

  /** Creates a square with random wrinkles that fills the picture. `scale` is the number of repetitions of the texture. */
  function wrinkledSquare(scale = 1) {
    const set = randomSet(seeded(7), 6, 16)
    const mesh = square(new MeshPhysicalMaterial(), scale)
    const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 16 })
    for (const [i, area] of wrinkles.areaNames.entries()) wrinkles.setActivation(area, 0.2 + 0.1 * i)
    return { mesh, wrinkles, scene: new Scene().add(mesh, new DirectionalLight(), new AmbientLight()) }
  }

  it.each([1, 3])(
    'looks the same after another face joins the map, with %i repetitions of the texture',
    async (scale) => {
      const { wrinkles, scene } = wrinkledSquare(scale)
      const draw = () => harness.render(scene, squareCamera(), SIZE)
      const alone = await draw()
      const other = wrinkledSquare(scale)
      expect(largestDifference(await draw(), alone)).toBeLessThan(ROUNDING)
      other.wrinkles.dispose()
      expect(largestDifference(await draw(), alone)).toBeLessThan(ROUNDING)
      wrinkles.dispose()
      const shown = await draw()
      expect(largestDifference(shown, alone)).toBeGreaterThan(0.1)
    },
  )

  it('switches to the shared program when another face joins, before that face is drawn', async () => {
    const first = wrinkledSquare()
    const renderer = harness.renderer as WebGLRenderer
    await harness.render(first.scene, squareCamera(), SIZE)
    const second = wrinkledSquare()
    const both = new Scene().add(first.mesh, second.mesh, new DirectionalLight(), new AmbientLight())
    const target = new RenderTarget(SIZE, SIZE)
    renderer.setRenderTarget(target as never)
    await renderer.compileAsync(both, squareCamera())
    const programs = harness.programs()
    renderer.render(both, squareCamera())
    renderer.setRenderTarget(null)
    expect(harness.programs()).toBeLessThanOrEqual(programs)
    target.dispose()
    first.wrinkles.dispose()
    second.wrinkles.dispose()
  })
})

describe.each(RENDERERS)('normals of layers that point into the surface, on %s', (name) => {
  it('leave the skin unchanged where nothing wrinkles', async () => {
    const harness = await createHarness(name)
    const random = seeded(5)
    const material = new MeshPhysicalMaterial({ normalMap: mapOf(randomNormals(random, 16)) })
    const scene = (own: Material) => {
      const mesh = square(own)
      return { mesh, scene: new Scene().add(mesh, new DirectionalLight(), new AmbientLight()) }
    }
    const plain = await harness.render(scene(material).scene, squareCamera(), SIZE)
    for (const details of [1, 2]) {
      const { mesh, scene: wrinkled } = scene(material.clone())
      const layers = Array.from({ length: details }, (_, i) =>
        layer(`layer${i}`, 'detail', { ...randomImage(random, 16), ...(i === 0 && BLACK) }),
      )
      const areas = randomAreas(random, 4, 16).map((area, i) => ({ ...area, layer: `layer${i % details}` }))
      const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: 16 })
      const shown = await harness.render(wrinkled, squareCamera(), SIZE)
      expect(largestDifference(shown, plain), `${details} layers`).toBeLessThan(ROUNDING)
      wrinkles.setActivation('area0', 1)
      const active = await harness.render(wrinkled, squareCamera(), SIZE)
      expect(active.every(Number.isFinite)).toBe(true)
      wrinkles.dispose()
    }
    harness.dispose()
  })
})

/** Black image, because baking programs leave unused texels of normal maps black. Decoded, black points into the surface. */
const BLACK = { width: 16, height: 16, data: new Uint8Array(4 * 16 * 16) }
