import type { LayerKind } from 'furrow'
import { InstancedMesh, MeshLambertMaterial, PlaneGeometry } from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'
import { mixingCase } from './mixing.ts'

/** Texels of the maps, and pixels: of the areas there are fewer. */
const MAP = 64

/** The map holds bytes: half a step in each component, and the normal is as long as it is. */
const MOST = 3 / 255

const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'detail'],
  ['replace', 'replace', 'detail', 'detail'],
]

describe.each(RENDERERS)('the composed mode on %s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  it.each(KINDS)(
    'writes what the reference mixes of %s %s %s %s layers, and only what moved anew',
    async (...kinds) => {
      const random = seeded(11)
      const own = mixingCase(harness, random, kinds.filter(Boolean), { mode: 'composed', map: MAP })
      const { wrinkles } = own
      const error = () => own.largestError(squareCamera(), MAP)
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random() * 0.5)
      expect(await error()).toBeLessThanOrEqual(MOST)
      for (let i = 0; i < 5; i++) {
        for (const area of wrinkles.areaNames.filter(() => random() < 0.3)) {
          wrinkles.setActivation(area, random() < 0.3 ? 0 : random())
        }
        expect(await error()).toBeLessThanOrEqual(MOST)
      }
      own.remove(wrinkles.areaNames[3])
      expect(await error()).toBeLessThanOrEqual(MOST)
      own.dispose()
    },
  )

  it('gives the material its own map back, and takes turns with the other modes', async () => {
    const random = seeded(3)
    const own = mixingCase(harness, random, ['replace'], { mode: 'composed', map: MAP })
    const { wrinkles, material, normalMap } = own
    expect(material.normalMap).not.toBe(normalMap)
    expect(wrinkles.cloneMaterial()).toMatchObject({ normalMap })
    expect(material.normalMap).not.toBe(normalMap)
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, random())
    for (const mode of ['default', 'composed', 'default', 'composed'] as const) {
      wrinkles.mode = mode
      expect(await own.largestError(squareCamera(), MAP)).toBeLessThanOrEqual(MOST)
    }
    wrinkles.mode = 'off'
    expect(material.normalMap).toBe(normalMap)
    own.dispose()
    expect(material.normalMap).toBe(normalMap)
  })

  it('draws nothing while nothing moves', async () => {
    const own = mixingCase(harness, seeded(5), ['detail'], { mode: 'composed', map: MAP })
    own.wrinkles.setActivation(own.wrinkles.areaNames[0], 0.5)
    await own.largestError(squareCamera(), MAP)
    const { render } = harness.renderer
    let renders = 0
    harness.renderer.render = (...scene: Parameters<typeof render>) => {
      renders++
      return render.apply(harness.renderer, scene)
    }
    await own.largestError(squareCamera(), MAP)
    expect(renders).toBe(3)
    own.wrinkles.setActivation(own.wrinkles.areaNames[0], 0.6)
    await own.largestError(squareCamera(), MAP)
    // The influence map and the normal map, once for three pictures.
    expect(renders).toBe(3 + 3 + 2)
    Object.assign(harness.renderer, { render })
    own.dispose()
  })

  it('refuses instances, and stays as it was', () => {
    const set = randomSet(seeded(1), 2, 8)
    const wrinkles = new harness.Wrinkles(
      new InstancedMesh(new PlaneGeometry(), new MeshLambertMaterial(), 3),
      set,
    )
    expect(() => {
      wrinkles.mode = 'composed'
    }).toThrow(/instances cannot have wrinkles of their own in this mode, got "composed"/)
    expect(wrinkles.mode).toBe('default')
    wrinkles.dispose()
  })

  it('needs no map of the material', async () => {
    const mesh = square(new MeshLambertMaterial())
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(1), 2, 8), { mode: 'composed' })
    expect((mesh.material as MeshLambertMaterial).normalMap).not.toBeNull()
    wrinkles.dispose()
    expect((mesh.material as MeshLambertMaterial).normalMap).toBeNull()
  })
})
