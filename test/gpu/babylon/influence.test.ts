import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { GrayImage, WrinkleSet } from 'furrow'
import { Wrinkles } from 'furrow/babylon'
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { STEP } from '../difference.ts'
import { casesIn } from '../harness.ts'
import { influenceDifference, type UvTransform } from '../influence-difference.ts'
import { type BabylonHarness, createHarness, ENGINES, square } from './harness.ts'

const CASES = casesIn(200)
const PIXELS = 32
const AREA = 32

/** Roughness in Babylon.js's debug modes: neither normalised nor in gamma space. */
const SHOW_ROUGHNESS = 63

describe.each(ENGINES)('influence in Babylon.js on %s', (name) => {
  let harness: BabylonHarness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterEach(() => expect(harness.errors).toEqual([]))
  afterAll(() => harness.dispose())

  it(`is within 1/255 of the reference in ${CASES} random cases`, async () => {
    const random = seeded(2008)
    const scene = harness.createScene()
    let worst = 0
    // Each case is disposed of after the next is drawn, so that the engine keeps their common program.
    let release = () => {}
    for (let i = 0; i < CASES; i++) {
      const count = 1 + Math.floor(random() * 64)
      const set = smooth(randomSet(random, count, AREA))
      const scale = 0.2 + random() * 1.2
      const offset = [random() * 0.4 - 0.2, random() * 0.4 - 0.2]
      const activations = set.areas.map(() => (random() < 0.3 ? 0 : Math.min(1, random() * (4 / count))))
      const { error, mesh } = await largestError(harness, scene, set, activations, { scale, offset })
      worst = Math.max(worst, error)
      release()
      mesh.setEnabled(false)
      release = () => mesh.dispose(false, true)
    }
    scene.dispose()
    expect(worst).toBeLessThanOrEqual(STEP)
  })
})

/** Fully wrinkled skin has no roughness: what is left of the material's own is 1 less the influence. */
function smooth({ layers: [layer], areas }: WrinkleSet): WrinkleSet {
  const { width, height } = layer.normal as GrayImage
  return { layers: [{ ...layer, roughness: { width, height, data: new Uint8Array(width * height) } }], areas }
}

async function largestError(
  harness: BabylonHarness,
  scene: Scene,
  set: WrinkleSet,
  activations: readonly number[],
  transform: UvTransform,
) {
  const mesh = square(scene, transform.scale, [...transform.offset])
  const material = new PBRMaterial('skin', scene)
  Object.assign(material, { metallic: 0, roughness: 1, debugMode: SHOW_ROUGHNESS, debugLimit: -1 })
  mesh.material = material
  const wrinkles = new Wrinkles(mesh, set, { areaSize: AREA })
  for (const [i, area] of set.areas.entries()) wrinkles.setActivation(area.name, activations[i])
  const pixels = await harness.render(scene, PIXELS)
  const shown = (i: number) => 1 - pixels[i * 4]
  const error = influenceDifference(set, AREA, activations, transform, shown, PIXELS)
  return { error, mesh }
}
