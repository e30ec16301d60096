import {
  DataTexture,
  DirectionalLight,
  LinearFilter,
  LinearMipmapLinearFilter,
  MeshPhysicalMaterial,
  RepeatWrapping,
  Scene,
  type Texture,
} from 'three'
import { describe, expect, it } from 'vitest'
import { randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { harnessOn, square, squareCamera } from './harness.ts'
import { readLevel } from './read-level.ts'

const SIZE = 64
const LEVELS = [0, 1, 2, 3, 4, 5, 6]

/** Tests only WebGL. On WebGPU the GPU makes all levels but the first. */
describe('mipmap levels of the composed map on webgl', () => {
  const harness = harnessOn('webgl')

  const random = seeded(5)
  const area = (name: string, x0: number, x1: number) => {
    const data = new Uint8Array(SIZE * SIZE)
    for (let i = 0; i < data.length; i++) data[i] = i % SIZE >= x0 && i % SIZE < x1 ? 255 : 0
    return { name, weights: { width: SIZE, height: SIZE, data } }
  }
  const base = randomNormals(random, SIZE)
  const layer = { name: 'all', kind: 'replace' as const, normal: randomNormals(random, SIZE) }
  const set = { layers: [layer], areas: [area('left', 0, 32), area('right', 32, 64), area('some', 5, 23)] }

  /** Returns the RGB bytes of all levels of a texture. Alpha is not part of the normal. */
  const levelsOf = async (texture: Texture) => {
    const levels = await Promise.all(LEVELS.map((level) => readLevel(harness, texture, null, level)))
    return levels.map((rgba) => [...rgba.filter((_, i) => i % 4 < 3)])
  }

  /** Creates a face whose normal map has the size of the layer. `levels` draws it and returns the levels of the composed map. */
  const createFace = (minFilter: Texture['minFilter'] = LinearMipmapLinearFilter) => {
    const normalMap = new DataTexture(base.data, SIZE, SIZE)
    normalMap.generateMipmaps = true
    normalMap.minFilter = minFilter
    normalMap.wrapS = normalMap.wrapT = RepeatWrapping
    normalMap.needsUpdate = true
    const material = new MeshPhysicalMaterial({ normalMap })
    const mesh = square(material)
    const scene = new Scene()
    scene.add(mesh, new DirectionalLight())
    const wrinkles = new harness.Wrinkles(mesh, set, { mode: 'composed', areaSize: SIZE })
    const levels = async (activations: Record<string, number>) => {
      for (const [name, value] of Object.entries(activations)) wrinkles.setActivation(name, value)
      await harness.renderBytes(scene, squareCamera(), 16)
      return levelsOf(material.normalMap!)
    }
    return { normalMap, levels }
  }

  it("equal those of the face's own map at rest, and those of the layer under full influence", async () => {
    const { normalMap, levels } = createFace()
    const atRest = await levels({})
    const own = await levelsOf(normalMap)
    expect(atRest).toEqual(own)
    const all = await levels({ left: 1, right: 1 })
    for (const channel of [0, 1]) {
      expect(Math.abs(all[6][channel] - meanOf(layer.normal.data, channel))).toBeLessThan(2)
    }
    expect(all[6]).not.toEqual(own[6])
  })

  it("are made by the GPU if the face's own map has no mipmaps", async () => {
    const levels = await createFace(LinearFilter).levels({})
    for (const channel of [0, 1]) {
      expect(Math.abs(levels[6][channel] - meanOf(base.data, channel))).toBeLessThan(2)
    }
  })

  it('do not depend on whether some or all areas are redrawn', async () => {
    const some = { left: 0.3, right: 0, some: 0.6 }
    const fresh = await createFace().levels(some)
    const { levels } = createFace()
    await levels({ left: 0.8, right: 0 })
    await levels({ left: 0.8, right: 0, some: 1 })
    const differenceTo = (other: number[][]) => largestDifference(other.flat(), fresh.flat())
    expect(differenceTo(await levels({ some: 0.6 }))).toBeGreaterThan(20)
    // The rectangles drawn differ, and interpolation between their corners rounds differently.
    expect(differenceTo(await levels({ left: 0.3 }))).toBeLessThanOrEqual(1)
  })
})

function meanOf(rgba: Uint8Array, channel: number): number {
  const values = rgba.filter((_, i) => i % 4 === channel)
  return values.reduce((sum, value) => sum + value, 0) / values.length
}
