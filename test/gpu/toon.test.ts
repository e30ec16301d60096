import { packColours, reference } from 'furrow/internal'
import { Color, DataTexture, DirectionalLight, MeshToonMaterial, NearestFilter, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomAreas, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { influenceAt } from './influence-at.ts'

/** Width of the maps (texels) and of the picture (pixels). */
const SIZE = 32

describe.each(RENDERERS)('a toon material on %s', (name) => {
  const harness = harnessOn(name)

  it('draws wrinkles as lines like the float64 reference, although its few light levels show no slopes', async () => {
    const random = seeded(21)
    const normals = randomNormals(random, SIZE)
    const areas = randomAreas(random, 4, 16)
    const gradientMap = new DataTexture(new Uint8Array(4).fill(255), 1, 1)
    gradientMap.minFilter = gradientMap.magFilter = NearestFilter
    gradientMap.needsUpdate = true
    const colour = [0.9, 0.6, 0.4]
    const mesh = square(new MeshToonMaterial({ color: new Color(...colour), gradientMap }))
    const set = { layers: [layer('skin', 'detail', normals)], areas }
    const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 16 })
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random() * 0.5)
    const scene = new Scene().add(mesh, new DirectionalLight(0xffffff, Math.PI))
    const shown = await harness.render(scene, squareCamera(), SIZE)

    const maps = packColours([normals])
    const activations = areas.map(({ name }) => wrinkles.getActivation(name))
    const influenceOf = influenceAt(areas, activations, 16)
    let worst = 0
    let lines = 0
    for (let i = 0; i < SIZE * SIZE; i++) {
      const u = ((i % SIZE) + 0.5) / SIZE
      const v = 1 - (Math.floor(i / SIZE) + 0.5) / SIZE
      const normal = reference.unpackNormal([0, 1, 2].map((c) => reference.sampleArray(maps, u, v, 0, c)))
      const mixed = reference.mixNormals(
        [0, 0, 1],
        [{ kind: 'detail', normal, influence: influenceOf(u, v) }],
      )
      const exact = reference.toonColour(colour, [0, 0, 1], mixed)
      for (let c = 0; c < 3; c++) worst = Math.max(worst, Math.abs(shown[4 * i + c] - exact[c]))
      if (exact[1] < 0.95 * colour[1]) lines++
    }
    expect(worst).toBeLessThanOrEqual(2 / 255)
    expect(lines).toBeGreaterThan((SIZE * SIZE) / 10)
    wrinkles.dispose()
  })
})
