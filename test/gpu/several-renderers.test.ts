import { DirectionalLight, MeshPhysicalMaterial, Scene } from 'three'
import { expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, imagesOf, RENDERERS, square, squareCamera } from './harness.ts'

/** Width and height of the pictures, pixels. */
const SIDE = 64

/** Creates a face with wrinkles for one renderer. */
function faceOn(harness: Harness) {
  const mesh = square(new MeshPhysicalMaterial())
  const light = new DirectionalLight()
  light.position.set(1, 1, 1)
  const scene = new Scene().add(mesh, light)
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8), { areaSize: 8 })
  const set = (value: number) => {
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, value)
  }
  set(0.4)
  const picture = async () => (await harness.renderBytes(scene, squareCamera(), SIDE)).slice()
  return {
    set,
    wrinkles,
    scene,
    picture,
    /** Draws a picture, and returns the number of render calls. */
    async images() {
      const before = imagesOf(harness.renderer)
      await picture()
      return imagesOf(harness.renderer) - before
    },
  }
}

it.each(RENDERERS)('faces of two renderers on one page are independent on %s', async (name) => {
  const harnesses = [await createHarness(name), await createHarness(name)]
  // One renderer has already drawn some images, as on a page that creates the renderers one after the other.
  for (const lead of [0, 1, 2, 3]) {
    const faces = harnesses.map((harness) => faceOn(harness))
    const [first, second] = faces
    for (let i = 0; i < lead; i++) harnesses[1].renderer.render(new Scene(), squareCamera())
    const wanted = await first.picture()
    expect(new Set(wanted).size).toBeGreaterThan(8)
    for (let i = 0; i < 3; i++) {
      expect(largestDifference(await second.picture(), wanted), `${lead} second ${i}`).toBe(0)
      expect(largestDifference(await first.picture(), wanted), `${lead} first ${i}`).toBe(0)
    }
    // Drawing with one renderer must not redraw the influence of a still face on the other.
    for (let i = 0; i < 2; i++) for (const { images } of faces) expect(await images()).toBe(1)
    for (const { set } of faces) set(0.9)
    const moved = await first.picture()
    expect(largestDifference(moved, wanted)).toBeGreaterThan(8)
    expect(largestDifference(await second.picture(), moved)).toBe(0)
    for (const { wrinkles } of faces) wrinkles.dispose()
  }
  for (const { dispose } of harnesses) dispose()
})
