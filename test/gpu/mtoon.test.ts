import { MToonMaterial } from '@pixiv/three-vrm-materials-mtoon'
import type { MToonNodeMaterial } from '@pixiv/three-vrm-materials-mtoon/nodes'
import {
  AmbientLight,
  BufferAttribute,
  Color,
  DataTexture,
  DirectionalLight,
  type Material,
  type Mesh,
  REVISION,
  Scene,
} from 'three'
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest'
import { randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'

const SIZE = 32

/** three-vrm 3.5's nodes use what r187 of three.js has dropped: without wrinkles too, they draw nothing. */
const hasNodes = Number(REVISION) < 187
const PATHS = RENDERERS.filter((name) => name === 'webgl' || hasNodes)

const COLOURS = { color: new Color(0.9, 0.7, 0.6), shadeColorFactor: new Color(0.7, 0.4, 0.4) }

afterEach(() => vi.restoreAllMocks())

describe.each(PATHS)('MToon on %s', (name) => {
  let harness: Harness
  let Nodes: typeof MToonNodeMaterial
  beforeAll(async () => {
    harness = await createHarness(name)
    if (hasNodes) Nodes = (await import('@pixiv/three-vrm-materials-mtoon/nodes')).MToonNodeMaterial
  })
  afterAll(() => harness.dispose())

  const mtoon = (parameters: object = {}) =>
    name === 'webgl'
      ? new MToonMaterial({ ...COLOURS, ...parameters } as never)
      : new Nodes({ ...COLOURS, ...parameters } as never)
  const picture = async (mesh: Mesh) => {
    // Light from the front, where MToon shows the same colour whatever the normal.
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(0, 0.2, 1)
    const scene = new Scene().add(mesh, light, new AmbientLight(0xffffff, 0.2))
    for (let i = 0; i < 3; i++) await harness.renderBytes(scene, squareCamera(), SIZE)
    return harness.renderBytes(scene, squareCamera(), SIZE)
  }
  const ownMap = () => {
    const map = new DataTexture(randomNormals(seeded(1), 16).data, 16, 16)
    map.needsUpdate = true
    return map
  }

  it.each([
    ['with a normal map', () => mtoon({ normalMap: ownMap() })],
    ['without one', () => mtoon()],
  ])('wrinkles clearly %s, is as before at rest, and is restored', async (_, create) => {
    const warn = vi.spyOn(console, 'warn')
    const material = create()
    const { normalMap } = material
    const mesh = square(material)
    const plain = await picture(mesh)
    expect(meanOf(plain)).toBeGreaterThan(100)
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 4, 8, 16), { areaSize: 8 })
    expect(wrinkles.mode).toBe('default')
    expect(meanDifference(await picture(mesh), plain)).toBeLessThan(0.1)
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 1)
    expect(meanDifference(await picture(mesh), plain)).toBeGreaterThan(15)
    wrinkles.mode = 'composed'
    expect(meanOf(await picture(mesh))).toBeGreaterThan(100)
    expect(wrinkles.mode).toBe('composed')
    wrinkles.dispose()
    expect(meanDifference(await picture(mesh), plain)).toBe(0)
    expect(material.normalMap).toBe(normalMap)
    expect(warn.mock.calls.filter(([text]) => /^Wrinkles/.test(text))).toEqual([])
  })

  it('keeps its outline, which is a second material of the mesh', async () => {
    const mesh = square(mtoon()) as Mesh<Mesh['geometry'], Material | Material[]>
    const outline = mtoon({ isOutline: true })
    mesh.material = [mesh.material as Material, outline]
    mesh.geometry.addGroup(0, 6, 0)
    mesh.geometry.addGroup(0, 6, 1)
    const plain = await picture(mesh as Mesh)
    const wrinkles = new harness.Wrinkles(mesh as Mesh, randomSet(seeded(3), 4, 8, 16), { areaSize: 8 })
    expect(meanDifference(await picture(mesh as Mesh), plain)).toBeLessThan(0.1)
    const [copy, second] = wrinkles.cloneMaterial() as Material[]
    expect(second).toBe(outline)
    expect(copy.constructor).toBe(outline.constructor)
    expect(Object.keys((copy as MToonMaterial).uniforms ?? {}).filter((key) => /furrow/i.test(key))).toEqual(
      [],
    )
    wrinkles.dispose()
  })
})

it('an MToon face with tangents, whose shader takes no normal map, stays plain with one warning', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
  vi.spyOn(console, 'error').mockImplementation(() => {})
  const harness = await createHarness('webgl')
  const mesh = square(new MToonMaterial(COLOURS as never))
  mesh.geometry.setAttribute('tangent', new BufferAttribute(new Float32Array(16).fill(1), 4))
  const scene = new Scene().add(mesh, new AmbientLight(0xffffff, 3))
  const plain = await harness.renderBytes(scene, squareCamera(), SIZE)
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 4, 8, 16))
  await harness.renderBytes(scene, squareCamera(), SIZE)
  expect(meanDifference(await harness.renderBytes(scene, squareCamera(), SIZE), plain)).toBe(0)
  expect(wrinkles.mode).toBe('off')
  expect(warn.mock.calls.filter(([text]) => /^Wrinkles/.test(text))).toHaveLength(1)
  wrinkles.dispose()
  harness.dispose()
})

function meanOf(pixels: Uint8Array): number {
  return pixels.reduce((sum, value) => sum + value, 0) / pixels.length
}

function meanDifference(a: Uint8Array, b: Uint8Array): number {
  return meanOf(a.map((value, i) => Math.abs(value - b[i])))
}
