import { type LayerKind, packAreas, packColours, reference } from 'furrow'
import { DataTexture, DirectionalLight, LinearFilter, MeshLambertMaterial, Scene } from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { layer, randomAreas, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'

const PIXELS = 32
const MAP = 16
const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'replace'],
  ['replace', 'detail'],
  ['detail', 'detail'],
  ['replace', 'replace', 'detail', 'detail'],
]

describe.each(RENDERERS)('the default mode on %s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  it.each(KINDS)('mixes %s %s %s %s layers as the reference does', async (...kinds) => {
    const random = seeded(7)
    for (let i = 0; i < 10; i++) {
      expect(await largestError(harness, random, kinds.filter(Boolean))).toBeLessThanOrEqual(2 / 255)
    }
  })
})

/** Three lights along the axes read the three components of the shaded normal, one per picture. */
async function largestError(harness: Harness, random: () => number, kinds: LayerKind[]): Promise<number> {
  const base = randomNormals(random, MAP)
  const set = {
    layers: kinds.map((kind, i) => layer(`layer${i}`, kind, randomNormals(random, MAP))),
    areas: randomAreas(random, 12, MAP).map((area, i) => ({ ...area, layer: `layer${i % kinds.length}` })),
  }
  const normalMap = new DataTexture(base.data, MAP, MAP)
  normalMap.minFilter = LinearFilter
  normalMap.magFilter = LinearFilter
  normalMap.needsUpdate = true
  const material = new MeshLambertMaterial({ normalMap })
  material.normalScale.set(1, -1)
  const mesh = square(material, 0.8, [0.1, 0.1])
  const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: MAP })
  for (const { name } of set.areas) wrinkles.setActivation(name, random() * 0.5)
  const scene = new Scene()
  const light = new DirectionalLight(0xffffff, Math.PI)
  scene.add(mesh, light)

  const areas = packAreas(
    set.areas.map(({ weights }) => weights),
    MAP,
  )
  const maps = packColours([base, ...set.layers.map(({ normal }) => normal)])
  const table = set.areas.map(({ name, combine }, i) => ({
    activation: wrinkles.getActivation(name),
    layer: i % kinds.length,
    combine: combine ?? ('sum' as const),
  }))
  let worst = 0
  for (const axis of [0, 1, 2]) {
    light.position.set(0, 0, 0).setComponent(axis, 1)
    const pixels = await harness.render(scene, squareCamera(), PIXELS)
    for (let i = 0; i < PIXELS * PIXELS; i++) {
      const u = (((i % PIXELS) + 0.5) / PIXELS) * 0.8 + 0.1
      const v = (1 - (Math.floor(i / PIXELS) + 0.5) / PIXELS) * 0.8 + 0.1
      const normalOf = (map: number) =>
        reference.unpackNormal([0, 1, 2].map((c) => reference.sampleArray(maps, u, v, map, c)))
      const shares = kinds.map((kind, k) => ({
        kind,
        normal: normalOf(k + 1),
        influence: reference.influenceFromMap(areas, table, u, v, k),
      }))
      const exact = Math.max(0, reference.mixNormals(normalOf(0), shares)[axis])
      worst = Math.max(worst, Math.abs(pixels[i * 4] - exact))
    }
  }
  wrinkles.dispose()
  normalMap.dispose()
  material.dispose()
  mesh.geometry.dispose()
  return worst
}
