import type { LayerKind } from 'furrow'
import type { WrinkleMode } from 'furrow/three'
import {
  DataTexture,
  DirectionalLight,
  InstancedMesh,
  LinearFilter,
  MeshLambertMaterial,
  PlaneGeometry,
  Scene,
} from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomAreas, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { mixingCase } from './mixing.ts'

/** Width of the maps (texels) and of the pictures (pixels). Areas are smaller. */
const MAP = 64

/** Tolerance for the composed normals, which are rounded to bytes and not normalised afterwards. */
const TOLERANCE = 3 / 255

const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'detail'],
  ['replace', 'replace', 'detail', 'detail'],
]

describe.each(RENDERERS)('the composed mode on %s', (name) => {
  const harness = harnessOn(name)

  it.each(KINDS)(
    'writes the normals of the reference for %s %s %s %s layers, also when only some areas change',
    async (...kinds) => {
      const random = seeded(11)
      const mixing = mixingCase(harness, random, kinds.filter(Boolean), { mode: 'composed', map: MAP })
      const { wrinkles } = mixing
      const error = () => mixing.largestError(squareCamera(), MAP)
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random() * 0.5)
      expect(await error()).toBeLessThanOrEqual(TOLERANCE)
      for (let i = 0; i < 5; i++) {
        for (const area of wrinkles.areaNames.filter(() => random() < 0.3)) {
          wrinkles.setActivation(area, random() < 0.3 ? 0 : random())
        }
        expect(await error()).toBeLessThanOrEqual(TOLERANCE)
      }
      mixing.remove(wrinkles.areaNames[3])
      expect(await error()).toBeLessThanOrEqual(TOLERANCE)
      mixing.dispose()
    },
  )

  it("filters a normal map that is smaller than the layers' maps", async () => {
    const random = seeded(7)
    const own = randomNormals(random, MAP / 4)
    const normalMap = new DataTexture(own.data, own.width, own.height)
    normalMap.minFilter = normalMap.magFilter = LinearFilter
    normalMap.needsUpdate = true
    const mesh = square(new MeshLambertMaterial({ normalMap }))
    const areas = randomAreas(random, 3, MAP / 4)
    const layers = [layer('layer0', 'detail', randomNormals(random, MAP))]
    const wrinkles = new harness.Wrinkles(mesh, { layers, areas })
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random())
    const scene = new Scene().add(mesh, new DirectionalLight(0xffffff, Math.PI))
    const picture = (mode: WrinkleMode) => {
      wrinkles.mode = mode
      return harness.render(scene, squareCamera(), MAP)
    }
    const [expected, shown] = [await picture('default'), await picture('composed')]
    expect(Math.max(...expected)).toBeGreaterThan(0.5)
    expect(largestDifference(expected, shown)).toBeLessThanOrEqual(TOLERANCE)
    wrinkles.dispose()
  })

  it("restores the material's own map, and alternates with the other modes", async () => {
    const random = seeded(3)
    const mixing = mixingCase(harness, random, ['replace'], { mode: 'composed', map: MAP })
    const { wrinkles, material, normalMap } = mixing
    expect(material.normalMap).not.toBe(normalMap)
    expect(wrinkles.cloneMaterial()).toMatchObject({ normalMap })
    expect(material.normalMap).not.toBe(normalMap)
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random())
    for (const mode of ['default', 'composed', 'default', 'composed'] as const) {
      wrinkles.mode = mode
      expect(await mixing.largestError(squareCamera(), MAP)).toBeLessThanOrEqual(TOLERANCE)
    }
    wrinkles.mode = 'off'
    expect(material.normalMap).toBe(normalMap)
    mixing.dispose()
    expect(material.normalMap).toBe(normalMap)
  })

  it('redraws nothing while activations stay the same', async () => {
    const mixing = mixingCase(harness, seeded(5), ['detail'], { mode: 'composed', map: MAP })
    mixing.wrinkles.setActivation(mixing.wrinkles.areaNames[0], 0.5)
    await mixing.largestError(squareCamera(), MAP)
    const { render } = harness.renderer
    let renders = 0
    harness.renderer.render = (...scene: Parameters<typeof render>) => {
      renders++
      return render.apply(harness.renderer, scene)
    }
    await mixing.largestError(squareCamera(), MAP)
    expect(renders).toBe(3)
    mixing.wrinkles.setActivation(mixing.wrinkles.areaNames[0], 0.6)
    await mixing.largestError(squareCamera(), MAP)
    // Three pictures, and two renders each of the influence map and the composed map.
    expect(renders).toBe(3 + 3 + 2)
    Object.assign(harness.renderer, { render })
    mixing.dispose()
  })

  it('refuses instances, and keeps the previous mode', () => {
    const set = randomSet(seeded(1), 2, 8)
    const wrinkles = new harness.Wrinkles(
      new InstancedMesh(new PlaneGeometry(), new MeshLambertMaterial(), 3),
      set,
    )
    expect(() => {
      wrinkles.mode = 'composed'
    }).toThrow(/mode unsupported for instances, got "composed"/)
    expect(wrinkles.mode).toBe('default')
    wrinkles.dispose()
  })

  it('works without a normal map on the material', async () => {
    const mesh = square(new MeshLambertMaterial())
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(1), 2, 8), { mode: 'composed' })
    expect((mesh.material as MeshLambertMaterial).normalMap).not.toBeNull()
    wrinkles.dispose()
    expect((mesh.material as MeshLambertMaterial).normalMap).toBeNull()
  })
})
