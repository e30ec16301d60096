import { DataTexture, DirectionalLight, type Mesh, MeshStandardMaterial, Scene } from 'three'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { largestDifference } from '../difference.ts'
import { harnessOn, RENDERERS, square, squareCamera } from '../harness.ts'
import { normalMap } from '../normal-map.ts'
import { quietConsole } from '../quiet-console.ts'

const MODES = ['default', 'composed'] as const

describe.each(RENDERERS)('a normal map that the page removes or replaces, on %s', (name) => {
  const console = quietConsole()
  const harness = harnessOn(name)

  const picture = (mesh: Mesh) => {
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    return harness.renderBytes(new Scene().add(mesh, light), squareCamera(), 32)
  }
  const wrinkled = (normalMap: DataTexture | null, mode: (typeof MODES)[number] | 'paper') => {
    const material = new MeshStandardMaterial({ color: 0xd0a080, normalMap })
    const mesh = square(material)
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 4, 8, 16), { mode, areaSize: 8 })
    wrinkles.setActivation('area1', 0.6)
    return { material, mesh, wrinkles }
  }
  const exchange = (material: MeshStandardMaterial, map: DataTexture | null) => {
    material.normalMap = map
    material.needsUpdate = true
  }
  const expectNoMessages = () => expect([console.warn.mock.calls, console.error.mock.calls]).toEqual([[], []])

  describe.each(MODES)('in %s mode', (mode) => {
    it('gives the same picture as if the material had never had the map', async () => {
      const [first, other] = [normalMap(1, 16), normalMap(2, 16)]
      const smooth = await picture(wrinkled(null, mode).mesh)
      const onOther = await picture(wrinkled(other, mode).mesh)
      const { material, mesh, wrinkles } = wrinkled(first, mode)
      const onFirst = await picture(mesh)
      expect(largestDifference(onFirst, smooth)).toBeGreaterThan(10)
      exchange(material, null)
      expect(largestDifference(await picture(mesh), smooth)).toBeLessThanOrEqual(1)
      expect(wrinkles.mode).toBe(mode)
      expect(largestDifference(onOther, onFirst)).toBeGreaterThan(10)
      exchange(material, other)
      expect(largestDifference(await picture(mesh), onOther)).toBeLessThanOrEqual(1)
      expectNoMessages()
    })

    it('stays as the page set it', async () => {
      const { material, mesh, wrinkles } = wrinkled(normalMap(1, 16), mode)
      await picture(mesh)
      exchange(material, null)
      expect((wrinkles.cloneMaterial() as MeshStandardMaterial).normalMap).toBeNull()
      await picture(mesh)
      wrinkles.mode = 'off'
      expect(material.normalMap).toBeNull()
      wrinkles.mode = mode
      await picture(mesh)
      wrinkles.dispose()
      expect(material.normalMap).toBeNull()
      const plain = square(new MeshStandardMaterial({ color: 0xd0a080 }))
      expect(await picture(mesh)).toEqual(await picture(plain))
      expectNoMessages()
    })
  })

  it('does not move the wrinkles', async () => {
    const place = (texture: DataTexture) => {
      texture.repeat.set(0.5, 0.5)
      texture.offset.set(0.25, 0.5)
      return texture
    }
    const flat = place(new DataTexture(new Uint8Array([128, 128, 255, 255]), 1, 1))
    flat.needsUpdate = true
    const expected = await picture(wrinkled(flat, 'default').mesh)
    const { material, mesh } = wrinkled(place(normalMap(1, 16)), 'default')
    exchange(material, null)
    expect(largestDifference(await picture(mesh), expected)).toBeLessThanOrEqual(3)
    expectNoMessages()
  })

  it("is still used in the paper's mode", async () => {
    const { material, mesh, wrinkles } = wrinkled(normalMap(1, 16), 'paper')
    const before = await picture(mesh)
    exchange(material, null)
    expect(await picture(mesh)).toEqual(before)
    wrinkles.dispose()
    expect(material.normalMap).toBeNull()
    expectNoMessages()
  })

  it('does not move the influence', async () => {
    const { material, mesh, wrinkles } = wrinkled(normalMap(1, 16), 'default')
    const influence = wrinkles.createInfluenceMaterial()
    mesh.material = influence as MeshStandardMaterial
    const expected = await picture(mesh)
    exchange(material, null)
    expect(await picture(mesh)).toEqual(expected)
    influence.dispose()
    mesh.material = wrinkles.createInfluenceMaterial() as MeshStandardMaterial
    expect(await picture(mesh)).toEqual(expected)
    expectNoMessages()
  })
})
