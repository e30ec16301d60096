import { addArea, removeArea } from 'furrow/three'
import { DirectionalLight, MeshPhysicalMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { randomAreas, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const COUNTS = [1, 2, 8, 19, 30, 256]

describe.each(RENDERERS)('shader programs on %s', (name) => {
  const harness = harnessOn(name)

  it.each(['default', 'paper'] as const)('use one program for 1 to 256 areas in %s mode', async (mode) => {
    const random = seeded(19)
    const areas = randomAreas(random, 256, 8)
    const set = randomSet(random, 1, 8)
    const mesh = square(new MeshPhysicalMaterial())
    const scene = new Scene()
    scene.add(mesh, new DirectionalLight())
    const wrinkles = new harness.Wrinkles(mesh, { ...set, areas: areas.slice(0, 1) }, { mode, areaSize: 8 })
    const pictures: string[] = []
    const draw = async () => {
      const last = wrinkles.areaNames[wrinkles.areaNames.length - 1]
      wrinkles.setActivation(last, 1)
      const pixels = await harness.renderBytes(scene, squareCamera(), 16)
      wrinkles.setActivation(last, 0)
      pictures.push(pixels.join())
      return harness.programs()
    }
    const programs = await draw()
    for (const count of COUNTS) {
      while (wrinkles.areaNames.length < count) addArea(wrinkles, areas[wrinkles.areaNames.length])
      expect(await draw(), `${count} areas`).toBe(programs)
    }
    for (const count of [...COUNTS].reverse()) {
      while (wrinkles.areaNames.length > count)
        removeArea(wrinkles, wrinkles.areaNames[wrinkles.areaNames.length - 1])
      expect(await draw(), `back at ${count} areas`).toBe(programs)
    }
    // Each number of areas gives another picture, which proves that the array of areas was rebuilt.
    expect(new Set(pictures).size).toBe(COUNTS.length)
    wrinkles.dispose()
  })
})
