import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import type { Layer } from 'furrow'
import { Wrinkles } from 'furrow/babylon'
import { afterEach, describe, expect, it } from 'vitest'
import { randomAreas } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { absorbed } from '../absorbed.ts'
import { largestDifference } from '../difference.ts'
import { casesIn } from '../harness.ts'
import { MAP, randomLayer } from '../layer-values.ts'
import { ENGINES, harnessOn, square } from './harness.ts'

const NAMES = ['all', 'pair', 'none']

describe.each(ENGINES)('onset maps in Babylon.js on %s', (name) => {
  const harness = harnessOn(name)
  afterEach(() => expect(harness.errors).toEqual([]))
  const cases = casesIn(200)

  it(`delay influence as in the reference in ${cases} random cases`, async () => {
    const random = seeded(41)
    // Bytes up to 200, because a larger onset magnifies the rounding errors of the influence map beyond the tolerance.
    const onset = () => {
      return { width: MAP, height: MAP, data: Uint8Array.from({ length: MAP * MAP }, () => random() * 200) }
    }
    let largestEffect = 0
    for (let i = 0; i < cases; i++) {
      const layers: Layer[] = [
        { ...randomLayer(random, 'all', ['occlusion', 'blood']), onset: onset() },
        { ...randomLayer(random, 'pair', ['blood']), onset: onset(), onsetStrength: random() },
        randomLayer(random, 'none', ['blood']),
      ]
      const areas = randomAreas(random, 6, MAP).map((area, k) => ({ ...area, layer: NAMES[k % 3] }))
      const scene = harness.createScene()
      const mesh = square(scene)
      mesh.material = new PBRMaterial('skin', scene)
      Object.assign(mesh.material, { metallic: 0, roughness: 0.8, unlit: true })
      const wrinkles = new Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
      const plain = await harness.render(scene, MAP)
      const activations = areas.map(() => (random() < 0.2 ? 0 : random()))
      for (const [k, area] of areas.entries()) wrinkles.setActivation(area.name, activations[k])
      const shown = await harness.render(scene, MAP)
      scene.dispose()
      const exact = absorbed(plain, layers, areas, activations)
      expect(largestDifference(shown, exact)).toBeLessThanOrEqual(2 / 255)
      const undelayed = layers.map(({ onset: _, ...layer }) => layer)
      largestEffect = Math.max(
        largestEffect,
        largestDifference(absorbed(plain, undelayed, areas, activations), exact),
      )
    }
    expect(largestEffect).toBeGreaterThan(32 / 255)
  })
})
