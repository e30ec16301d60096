import {
  AmbientLight,
  BackSide,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  type Material,
  type Mesh,
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  Scene,
} from 'three'
import { describe, expect, it, vi } from 'vitest'
import { layer, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { normalMap } from './normal-map.ts'

const MATERIALS = {
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshToonMaterial,
  MeshStandardMaterial,
  MeshPhysicalMaterial,
}

describe.each(RENDERERS)("the user's material on %s", (name) => {
  const harness = harnessOn(name)

  const picture = async (mesh: Mesh) => {
    const scene = new Scene()
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    scene.add(mesh, light, new AmbientLight(0xffffff, 0.2))
    return (await harness.renderBytes(scene, squareCamera(), 32)).join()
  }
  const wrinkled = (material: Material, mode: 'default' | 'paper' = 'default') => {
    const mesh = square(material)
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 4, 8, 16), { mode, areaSize: 8 })
    return { mesh, wrinkles }
  }

  describe.each(Object.entries(MATERIALS))('%s', (_, Kind) => {
    it.each(['default', 'paper'] as const)(
      'wrinkles in %s mode, and is restored on dispose',
      async (mode) => {
        const material = new Kind({ color: 0xd0a080 })
        const plain = await picture(square(material))
        const { mesh, wrinkles } = wrinkled(material, mode)
        wrinkles.setActivation('area1', 1)
        expect(await picture(mesh)).not.toBe(plain)
        wrinkles.mode = 'off'
        expect(await picture(mesh)).toBe(plain)
        wrinkles.mode = mode
        expect(await picture(mesh)).not.toBe(plain)
        wrinkles.dispose()
        expect(await picture(mesh)).toBe(plain)
        expect(material.normalMap).toBeNull()
      },
    )
  })

  it.each([
    { flatShading: false, side: FrontSide },
    { flatShading: false, side: DoubleSide },
    { flatShading: true, side: FrontSide },
    { flatShading: true, side: DoubleSide },
    { flatShading: true, side: BackSide },
  ])('looks the same while nothing is active: %j', async (sides) => {
    const material = new MeshStandardMaterial({ ...sides, normalMap: normalMap(2, 16) })
    const seen = (mesh: Mesh) => {
      if (sides.side !== FrontSide) mesh.rotation.y = Math.PI
      return picture(mesh)
    }
    const plain = await seen(square(material))
    expect(new Set(plain.split(',')).size).toBeGreaterThan(50)
    const { mesh, wrinkles } = wrinkled(material)
    expect(await seen(mesh)).toBe(plain)
    wrinkles.setActivation('area1', 1)
    expect(await seen(mesh)).not.toBe(plain)
    wrinkles.dispose()
  })

  it.each([
    ['default', 'off'],
    ['paper', 'off'],
    ['default', 'paper'],
  ] as const)('follows activations in %s mode again after %s', async (mode, other) => {
    const { mesh, wrinkles } = wrinkled(new MeshStandardMaterial(), mode)
    const show = (area: string) => {
      for (const each of wrinkles.areaNames) wrinkles.setActivation(each, each === area ? 1 : 0)
      return picture(mesh)
    }
    const pictures = [await show('area0'), await show('area1')]
    expect(pictures[0]).not.toBe(pictures[1])
    await show('area0')
    wrinkles.mode = other
    await picture(mesh)
    wrinkles.mode = mode
    expect(await show('area1')).toBe(pictures[1])
    expect(await show('area0')).toBe(pictures[0])
  })

  it('logs one warning after the page has replaced it, and the wrinkles can be moved to the new material', async () => {
    const { mesh, wrinkles } = wrinkled(new MeshStandardMaterial())
    wrinkles.setActivation('area1', 1)
    const shown = await picture(mesh)
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const [own, other] = [mesh.material, new MeshStandardMaterial({ name: 'next' })]
    // An effect may use another material for one pass of every frame. This does not replace the material.
    for (let i = 0; i < 40; i++) {
      mesh.material = other
      await picture(mesh)
      mesh.material = own
      await picture(mesh)
    }
    // The influence material does not replace the material either.
    mesh.material = wrinkles.createInfluenceMaterial()
    for (let i = 0; i < 40; i++) await picture(mesh)
    expect(warn).not.toHaveBeenCalled()
    mesh.material = other
    for (let i = 0; i < 40; i++) await picture(mesh)
    expect(warn.mock.calls).toEqual([[expect.stringMatching(/was replaced, got "next"; .*new Wrinkles\(/)]])
    const moved = new harness.Wrinkles(mesh, wrinkles)
    wrinkles.dispose()
    moved.setActivation('area1', 1)
    expect(await picture(mesh)).toBe(shown)
    expect(warn).toHaveBeenCalledTimes(1)
    warn.mockRestore()
    moved.dispose()
  })

  it('keeps normalScale', async () => {
    const material = new MeshStandardMaterial()
    const flat = await picture(square(material))
    const { mesh, wrinkles } = wrinkled(material)
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 1)
    const full = await picture(mesh)
    material.normalScale.set(0.3, 0.3)
    const weak = await picture(mesh)
    material.normalScale.set(0, 0)
    expect(weak).not.toBe(full)
    // normalScale applies after mixing, so 0 gives flat skin.
    expect(await picture(mesh)).toBe(flat)
  })

  it('keeps up with changes of its colour', async () => {
    const material = new MeshStandardMaterial({ color: 0xffffff })
    const { mesh, wrinkles } = wrinkled(material)
    wrinkles.setActivation('area0', 1)
    const white = await picture(mesh)
    material.color.set(0x804020)
    expect(await picture(mesh)).not.toBe(white)
  })

  it('keeps up with the transform of the base normal map', async () => {
    const material = new MeshStandardMaterial({ normalMap: normalMap(5, 16) })
    const { mesh, wrinkles } = wrinkled(material)
    wrinkles.setActivation('area0', 1)
    const rest = await picture(mesh)
    material.normalMap!.offset.set(0.25, 0)
    expect(await picture(mesh)).not.toBe(rest)
  })

  it('stays unchanged if wrinkles are refused as unsupported', () => {
    const set = randomSet(seeded(3), 1, 8, 16)
    const material = new MeshStandardMaterial()
    const two = { layers: [set.layers[0], layer('more', 'detail', set.layers[0].normal)], areas: set.areas }
    expect(() => new harness.Wrinkles(square(material), two, { mode: 'paper' })).toThrow(
      /Wrinkles.mode: the paper mode supports one layer only, got "skin, more", allowed: one layer/,
    )
    expect(material.normalMap).toBeNull()
    new harness.Wrinkles(square(material), set)
    expect(() => new harness.Wrinkles(square(material), set)).toThrow(/already shows wrinkles.*clone\(\)/)
  })
})
