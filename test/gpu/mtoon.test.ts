import { MToonMaterialLoaderPlugin, VRMLoaderPlugin, VRMUtils } from '@pixiv/three-vrm'
import { MToonMaterial } from '@pixiv/three-vrm-materials-mtoon'
import { MToonNodeMaterial } from '@pixiv/three-vrm-materials-mtoon/nodes'
import { wrinklesOf } from 'furrow/three'
import {
  AmbientLight,
  BufferAttribute,
  Color,
  DirectionalLight,
  type Group,
  type Material,
  Mesh,
  type Object3D,
  Scene,
} from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone as cloneSkinned } from 'three/addons/utils/SkeletonUtils.js'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { asVrm0 } from '../vrm.ts'
import {
  createHarness,
  type Harness,
  harnessOn,
  RENDERERS,
  type RendererName,
  square,
  squareCamera,
} from './harness.ts'
import { normalMap } from './normal-map.ts'
import { vrmFile } from './vrm-file.ts'
import { faceMeshes, wrinkledFile } from './wrinkled-file.ts'

const SIZE = 32

const COLOURS = { color: new Color(0.9, 0.7, 0.6), shadeColorFactor: new Color(0.7, 0.4, 0.4) }

afterEach(() => vi.restoreAllMocks())

describe.each(RENDERERS)('MToon on %s', (name) => {
  const harness = harnessOn(name)

  const mtoon = (parameters: object = {}) =>
    new (materialTypeFor(name))({ ...COLOURS, ...parameters } as never)
  const picture = (mesh: Mesh) => pictureOf(harness, mesh)

  it.each([
    ['with a normal map', () => mtoon({ normalMap: normalMap(1, 16) })],
    ['without one', () => mtoon()],
  ])('wrinkles clearly %s, looks the same at rest, and is restored on dispose', async (_, create) => {
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

/** Files with a face that three-vrm draws with MToon. */
const FILES: Record<string, () => Promise<Uint8Array<ArrayBuffer>>> = {
  'a VRM 1.0 with an outline': () => vrmFile(true),
  'a VRM 1.0 without one': () => vrmFile(false),
  'a VRM 0 with MToon': async () => asVrm0(await wrinkledFile(), 'VRM/MToon'),
  'a VRM 0 with VRM/UnlitTexture': async () => asVrm0(await wrinkledFile(), 'VRM/UnlitTexture'),
}

describe.each(
  RENDERERS.flatMap((name) => Object.entries(FILES).map(([kind, file]) => ({ name, kind, file }))),
)('the face of $kind on $name', ({ name, kind, file }) => {
  const harness = harnessOn(name)
  const { vrm, wrinkled, load } = loadersOf(harness, name, file)
  const picture = (root: Object3D) => pictureOf(harness, root)

  it.each([
    ['before', [wrinkled, vrm]],
    ['after', [vrm, wrinkled]],
  ])("wrinkles with its plugin registered %s three-vrm's", async (_, plugins) => {
    const warn = vi.spyOn(console, 'warn')
    const plain = await load(vrm)
    const gltf = await load(...plugins)
    expect(gltf.userData.vrm).toBeDefined()
    const meshes = faceMeshes(gltf.scene)
    const hasOutline = kind.endsWith('with an outline')
    for (const { material } of meshes) expect([material].flat()).toHaveLength(hasOutline ? 2 : 1)
    const [face, ...others] = wrinklesOf(gltf)
    expect(others).toEqual([])
    expect(meshes.map((mesh) => wrinklesOf(mesh))).toEqual([face, face])
    expect([meshes[0].material].flat()[0]).toBeInstanceOf(materialTypeFor(name))
    face.setActivation('b', 0)
    const rest = await picture(gltf.scene)
    expect(meanOf(rest)).toBeGreaterThan(60)
    expect(meanDifference(rest, await picture(plain.scene))).toBeLessThan(0.1)
    move(gltf.scene, 1)
    expect(meanDifference(await picture(gltf.scene), rest)).toBeGreaterThan(5)
    expect(face.getActivation('a')).toBe(1)
    expect(face.mode).toBe('default')
    face.dispose()
    expect(meanDifference(await picture(gltf.scene), await picture(plain.scene))).toBe(0)
    expect(warn.mock.calls.filter(([text]) => /wrinkle/i.test(text))).toEqual([])
  })
})

describe.each(
  RENDERERS.flatMap((name) => [
    { name, outline: 'with an outline', hasOutline: true },
    { name, outline: 'without one', hasOutline: false },
  ]),
)('the MToon face of a VRM on $name, $outline', ({ name, hasOutline }) => {
  const harness = harnessOn(name)
  const { vrm, wrinkled, load } = loadersOf(harness, name, () => vrmFile(hasOutline))
  const picture = (root: Object3D) => pictureOf(harness, root)

  it("wrinkles the same after three-vrm's optimisations, and in first person", async () => {
    const gltf = await load(vrm, wrinkled)
    move(gltf.scene, 1)
    const moved = await picture(gltf.scene)
    const { vrm: avatar } = gltf.userData
    VRMUtils.removeUnnecessaryVertices(gltf.scene)
    VRMUtils.combineSkeletons(gltf.scene)
    VRMUtils.rotateVRM0(avatar)
    avatar.firstPerson?.setup()
    expect(meanDifference(await picture(gltf.scene), moved)).toBe(0)
    const [face] = wrinklesOf(gltf)
    expect(face.getActivation('a')).toBe(1)
    move(gltf.scene, 0)
    expect(meanDifference(await picture(gltf.scene), moved)).toBeGreaterThan(5)
  })

  it('wrinkles independently in each copy, and on a mesh that a page makes', async () => {
    const gltf = await load(vrm, wrinkled)
    const rest = await picture(gltf.scene)
    const copy = cloneSkinned(gltf.scene) as Group
    const made = copy.clone(false)
    const loaded = faceMeshes(gltf.scene)
    for (const { geometry, material, morphTargetDictionary } of loaded) {
      const morphs = { morphTargetDictionary, morphTargetInfluences: [1] }
      made.add(Object.assign(new Mesh(geometry), { material, ...morphs }))
    }
    move(copy, 1)
    const moved = await picture(copy)
    expect(meanDifference(moved, rest)).toBeGreaterThan(5)
    expect(meanDifference(await picture(made), moved)).toBe(0)
    expect((made.children as Mesh[]).map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([1, 1])
    const outlines = [...loaded, ...made.children].map((mesh) => [(mesh as Mesh).material].flat()[1])
    expect(outlines.slice(2)).toEqual(outlines.slice(0, 2))
    made.clear()
    expect(loaded.map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([0, 0])
    expect(meanDifference(await picture(gltf.scene), rest)).toBe(0)
  })
})

it('an MToon face with tangents has no wrinkles and one warning, because its shader takes no normal map', async () => {
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

function materialTypeFor(name: RendererName): typeof MToonMaterial {
  return name === 'webgl' ? MToonMaterial : (MToonNodeMaterial as never)
}

type Register = (loader: GLTFLoader) => GLTFLoader

/** Returns loaders for a file: with the plugins of three-vrm and Furrow, or with only one of them. */
function loadersOf(harness: Harness, name: RendererName, file: () => Promise<Uint8Array<ArrayBuffer>>) {
  const vrm: Register = (loader) =>
    loader.register((parser) => {
      const materialType = materialTypeFor(name)
      const mtoonMaterialPlugin = new MToonMaterialLoaderPlugin(parser, { materialType })
      return new VRMLoaderPlugin(parser, { mtoonMaterialPlugin })
    })
  const wrinkled: Register = (loader) => loader.register((parser) => new harness.Plugin(parser))
  const load = async (...plugins: Register[]) => {
    const loader = plugins.reduce((all, register) => register(all), new GLTFLoader())
    return loader.parseAsync((await file()).buffer, '')
  }
  return { vrm, wrinkled, load }
}

function move(root: Object3D, weight: number): void {
  for (const { morphTargetInfluences } of faceMeshes(root)) morphTargetInfluences![0] = weight
}

/** Draws several frames and returns the last. A shader that fails to compile shows only after the first frame. */
async function pictureOf(harness: Harness, object: Object3D) {
  // In light from the front, MToon shows one colour for all normals. Wrinkles must show as lines.
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(0, 0.2, 1)
  const scene = new Scene().add(object, light, new AmbientLight(0xffffff, 0.2))
  for (let i = 0; i < 3; i++) await harness.renderBytes(scene, squareCamera(), SIZE)
  return harness.renderBytes(scene, squareCamera(), SIZE)
}

function meanOf(pixels: Uint8Array): number {
  return pixels.reduce((sum, value) => sum + value, 0) / pixels.length
}

function meanDifference(a: Uint8Array, b: Uint8Array): number {
  return meanOf(a.map((value, i) => Math.abs(value - b[i])))
}
