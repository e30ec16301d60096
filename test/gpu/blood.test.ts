import type { Area, GrayImage, Layer } from 'furrow'
import { packGrays, reference } from 'furrow/internal'
import { Color, DirectionalLight, MeshLambertMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { randomAreas } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { casesOn, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { influenceAt } from './influence-at.ts'
import { type Kind, MAP, randomLayer } from './layer-values.ts'

const PIXELS = 16
const AREAS = 4

/** The first of the three layers also has occlusion; the last has neither map. Occlusion changes neither direct nor diffuse light. */
const LAYERS = { both: ['occlusion', 'blood'], blood: ['blood'], neither: [] } as const satisfies Record<
  string,
  Kind[]
>
const NAMES = Object.keys(LAYERS)

describe.each(RENDERERS)('blood on %s', (name) => {
  const cases = casesOn(name)
  const harness = harnessOn(name)

  /** Renders a square of one colour at rest and with wrinkles. */
  async function show(layers: Layer[], areas: Area[], color: Color, activations: readonly number[]) {
    const mesh = square(new MeshLambertMaterial({ color }))
    const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
    const scene = new Scene()
    const light = new DirectionalLight(0xffffff, 3)
    light.position.set(0.3, 0.2, 1)
    scene.add(mesh, light)
    const plain = await harness.render(scene, squareCamera(), PIXELS)
    for (const [i, activation] of activations.entries()) wrinkles.setActivation(areas[i].name, activation)
    const shown = await harness.render(scene, squareCamera(), PIXELS)
    const dispose = () => {
      wrinkles.dispose()
      mesh.geometry.dispose()
    }
    return { plain, shown, dispose }
  }

  it(`absorbs light like the reference in ${cases} random cases`, async () => {
    const random = seeded(17)
    // Dispose after the next draw, so that the renderer keeps the shared program.
    let release = () => {}
    let largestEffect = 0
    for (let i = 0; i < cases; i++) {
      const layers = Object.entries(LAYERS).map(([layer, kinds]) => ({
        ...randomLayer(random, layer, kinds),
        bloodAmplitude: random() * 2,
      }))
      const areas = randomAreas(random, AREAS, MAP).map((area, k) => ({ ...area, layer: NAMES[k % 3] }))
      const activations = areas.map(() => (random() < 0.2 ? 0 : random()))
      const color = new Color(random(), random(), random()).multiplyScalar(0.5)
      const { plain, shown, dispose } = await show(layers, areas, color, activations)
      const exact = absorbed(plain, layers, areas, activations)
      expect(largestDifference(shown, exact)).toBeLessThanOrEqual(2 / 255)
      largestEffect = Math.max(largestEffect, largestDifference(plain, exact))
      release()
      release = dispose
    }
    expect(largestEffect).toBeGreaterThan(64 / 255)
    release()
  })

  it('changes no bit where the amount equals the amount at rest', async () => {
    const random = seeded(18)
    const areas = randomAreas(random, AREAS, MAP)
    const color = new Color(0.71, 0.43, 0.337)
    const layer = { ...randomLayer(random, 'both', LAYERS.both), bloodAmplitude: 2 }
    layer.blood!.data.fill(128)
    const { blood: _, ...bloodless } = layer
    const [own, other] = [await show([layer], areas, color, [1]), await show([bloodless], areas, color, [1])]
    expect(own.shown).toEqual(other.shown)
    for (const { dispose } of [own, other]) dispose()
  })
})

/** Applies the reference's blood to the picture at rest. */
function absorbed(
  plain: Float32Array,
  layers: readonly Layer[],
  areas: readonly Area[],
  activations: readonly number[],
): Float32Array {
  const influence = influenceAt(areas, activations, MAP, NAMES)
  const maps = layers.map(({ blood }) => blood && packGrays([blood as GrayImage]))
  const exact = plain.slice()
  for (let pixel = 0; pixel < PIXELS * PIXELS; pixel++) {
    const u = ((pixel % PIXELS) + 0.5) / PIXELS
    const v = 1 - (Math.floor(pixel / PIXELS) + 0.5) / PIXELS
    const values = layers.flatMap(({ bloodAmplitude }, i) => {
      const map = maps[i]
      if (!map) return []
      const value = [reference.bloodOf(reference.sampleArray(map, u, v, 0)) * bloodAmplitude!]
      return [{ value, influence: influence(u, v, i) }]
    })
    const [blood] = reference.mixValues([0], values)
    exact.set(reference.bloodColour([...plain.subarray(4 * pixel, 4 * pixel + 3)], blood), 4 * pixel)
  }
  return exact
}
