import type { Area, Layer } from 'furrow'
import { Color, DirectionalLight, MeshLambertMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { randomAreas } from '../cases.ts'
import { seeded } from '../random.ts'
import { absorbed } from './absorbed.ts'
import { largestDifference } from './difference.ts'
import { casesOn, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { type Kind, MAP, randomLayer } from './layer-values.ts'

const PIXELS = MAP
const AREAS = 4

/** Kinds of maps of three layers. Occlusion, stored in the same texture as blood, must not change the direct light. */
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
    // Disposes of a case only after the next one is drawn, so that the renderer keeps the program that all cases use.
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

  it('changes no bit if the map is neutral everywhere', async () => {
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
