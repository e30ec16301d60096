import type { WrinkleSet } from 'furrow'
import { updateLayer } from 'furrow/three'
import {
  DataTexture,
  DirectionalLight,
  InstancedMesh,
  Mesh,
  MeshPhysicalMaterial,
  type MeshStandardMaterial,
  MeshToonMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
} from 'three'
import { vec3 } from 'three/tsl'
import { MeshStandardNodeMaterial, type WebGPURenderer } from 'three/webgpu'
import { describe, expect, it, vi } from 'vitest'
import { PARTS as WEBGL } from '../../packages/furrow/src/three/webgl/webgl-wrinkles.ts'
import { PARTS as WEBGPU } from '../../packages/furrow/src/three/webgpu/webgpu-wrinkles.ts'
import { loadFace } from '../../stage/face.ts'
import { frameView } from '../../stage/views.ts'
import { randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { drawn, FRAMES, faceOf, MAP, UNSEEN, useFaces, watchShaders } from './auto-face.ts'
import { largestDifference, shareBeyond } from './difference.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'
import { loseContext } from './lose-context.ts'
import { normalMap } from './normal-map.ts'

/** Of a composed map of that size with its mipmaps. */
const BYTES = (MAP * MAP * 4 * 4) / 3

/** Unfiltered, as textures of data are by default. */
function oneTexel(): DataTexture {
  const map = new DataTexture(Uint8Array.of(128, 128, 255, 255), 1, 1)
  map.needsUpdate = true
  return map
}

describe.each(RENDERERS)('the mode auto on %s', (name) => {
  const { others } = name === 'webgl' ? WEBGL : WEBGPU
  const faces = useFaces(name)
  const { face } = faces

  // The second renderer's other backend takes the same steps.
  it.each(name === 'webgpu on webgl2' ? [6] : [1, 6])(
    'a change of a face that is drawn %s times smaller is not seen, nor compiled',
    async (times) => {
      const { skin, wrinkles: file } = await loadFace('/faces/human.glb')
      const [{ kind, name: layer, normal }] = file!.set.layers
      const set = { layers: [{ kind, name: layer, normal }], areas: file!.set.areas } as WrinkleSet
      const light = new DirectionalLight(0xffffff, 2)
      light.position.set(-1, 1.3, 1)
      const scene = new Scene().add(light)
      const camera = new PerspectiveCamera()
      frameView(skin, camera, 'front')
      camera.zoom = 2 / times
      camera.updateProjectionMatrix()
      scene.add(skin)
      let isComposed = false
      const material = skin.material as MeshStandardMaterial
      const own = material.normalMap
      skin.onAfterRender = () => {
        isComposed = material.normalMap !== own
      }
      const wrinkles = new faces.harness.Wrinkles(skin, set, { mode: 'default' })
      faces.disposers.push(() => wrinkles.dispose())
      for (const [i, area] of wrinkles.areaNames.entries()) wrinkles.setActivation(area, 0.4 + 0.1 * (i % 6))
      const picture = () => faces.harness.renderBytes(scene, camera, 320)
      const wanted = (await picture()).slice()
      expect(isComposed).toBe(false)
      wrinkles.mode = 'auto'
      expect(largestDifference((await picture()).slice(), wanted)).toBe(0)
      const compiled: number[] = []
      for (let i = 0; i < 20 * FRAMES && !isComposed; i++) {
        const before = faces.harness.programs()
        faces.harness.renderer.render(scene, camera)
        compiled.push(faces.harness.programs() - before)
        await drawn(faces.harness)
      }
      expect(isComposed).toBe(true)
      expect(compiled.length).toBeGreaterThan(30)
      const composed = (await picture()).slice()
      // On a graphics card, which filters with fewer bits, 7 of 409,600 values differ by up to 5.
      expect(shareBeyond(UNSEEN, composed, wanted)).toBeLessThan(1e-4)
      expect(largestDifference(composed, wanted)).toBeLessThanOrEqual(4 * UNSEEN)
      expect(material.normalMap).toBe(own)
      // The first one draws to the canvas for the first time.
      expect(compiled.slice(1).every((count) => count === 0)).toBe(true)
    },
  )

  it('shows the default mode before maps are made, a dual map while it moves, and a composed one while it is still', async () => {
    const { wrinkles, shown, samplesInfluence, picture, composed, moved, wanted } = face()
    expect(largestDifference(await picture(), await wanted())).toBe(0)
    expect(shown).toEqual({ isComposed: false, isDual: false, isSampled: true, isOcclusionReplaced: false })
    await moved()
    wrinkles.setActivation('area0', 0.9)
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    expect(shown).toEqual({ isComposed: false, isDual: true, isSampled: true, isOcclusionReplaced: false })
    await composed()
    expect(shown.isSampled).toBe(false)
    // What else reads it after the draw finds it as it was.
    expect(samplesInfluence()).toBe(true)
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    wrinkles.setActivation('area0', 0)
    wrinkles.setActivation('area1', 0)
    await composed()
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
  })

  it('shows a normal map that the page sets, maps that it changes, and areas that it adds', async () => {
    const { wrinkles, shown, picture, composed, moved, wanted, material } = face()
    const expectFresh = async (isDual = false) => {
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(isDual ? UNSEEN : 0)
      expect(shown).toMatchObject({ isComposed: false, isDual })
      await composed()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    }
    await composed()
    material.normalMap = normalMap(9, MAP)
    await expectFresh()
    const image = material.normalMap.image as { data: Uint8Array }
    image.data.set(randomNormals(seeded(12), MAP).data)
    material.normalMap.needsUpdate = true
    await expectFresh()
    updateLayer(wrinkles, 'skin', { normal: randomNormals(seeded(10), MAP) })
    await expectFresh()
    await moved()
    await composed()
    wrinkles.removeArea('area3')
    // Of maps it has changed none.
    await expectFresh(true)
  })

  it('a material without a normal map keeps its own between draws', async () => {
    const { picture, composed, wanted, material } = face({}, new MeshPhysicalMaterial())
    const own = material.normalMap
    await composed()
    expect(material.normalMap).toBe(own)
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
  })

  it.each([
    ['without a normal map', null],
    ['with one of one texel that is not filtered', oneTexel()],
  ])('a face %s is as smooth as in the default mode where it is smaller than its maps', async (_, map) => {
    const material = new MeshPhysicalMaterial({ normalMap: map })
    const { frames, wanted } = face({}, material, randomSet(seeded(4), 6, 16, 4 * MAP))
    await frames()
    await new Promise((resolve) => setTimeout(resolve, 50))
    expect(largestDifference(await frames(), await wanted())).toBeLessThanOrEqual(UNSEEN)
  })

  it('highlights of a glossy face do not show the steps of a map of bytes', async () => {
    const { shown, picture, composed, wanted, material } = face({ textureBudget: 2.1 * BYTES })
    for (const roughness of [0.35, 0.6, 0.2]) {
      material.roughness = roughness
      expect(largestDifference(await picture(), await wanted())).toBe(0)
      expect(shown.isComposed).toBe(false)
      await composed()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    }
  })

  it('maps of glossy faces take twice the memory', async () => {
    const glossy = new MeshPhysicalMaterial({ normalMap: normalMap(2, MAP), roughness: 0.35 })
    const { shown, frames, composed } = face({ textureBudget: 1.5 * BYTES }, glossy)
    await frames()
    expect(shown.isComposed).toBe(false)
    glossy.roughness = 0.6
    await composed()
    glossy.normalScale.set(1, -3)
    await frames()
    expect(shown.isComposed).toBe(false)
    glossy.normalScale.set(1, 1)
    await composed()
    glossy.roughnessMap = normalMap(3, MAP)
    await frames()
    expect(shown.isComposed).toBe(false)
  })

  it('faces share the memory that they may take', async () => {
    // A dual map and a composed one.
    const options = { textureBudget: 2.5 * BYTES }
    const first = face(options)
    await first.moved()
    await first.composed()
    const second = face(options)
    // Programs of the first are others once it is not alone in its influence map, and its maps are made anew.
    await first.moved()
    await first.composed()
    await second.frames()
    expect(second.shown).toMatchObject({ isComposed: false, isDual: false })
    first.wrinkles.dispose()
    await second.moved()
    await second.composed()
    const none = face({ textureBudget: 0 })
    await none.frames()
    expect(none.shown).toMatchObject({ isComposed: false, isDual: false })
  })

  it('small faces, those that fade, and views of the influence show the default mode', async () => {
    const { wrinkles, mesh, scene, shown, composed, frames } = face()
    await composed()
    const { material } = mesh
    const view = wrinkles.createInfluenceMaterial()
    mesh.material = view as typeof material
    await frames(2)
    expect(new Set(await faces.harness.renderBytes(scene, squareCamera(), MAP)).size).toBeGreaterThan(8)
    mesh.material = material
    view.dispose()
    await composed()
    for (let i = 0; i < 3; i++) await faces.harness.renderBytes(scene, squareCamera(), 8)
    expect(shown.isComposed).toBe(false)
    const faded = face({ fadeBelow: 100 })
    await faded.frames()
    expect(faded.shown.isComposed).toBe(false)
  })

  it('toon materials, normals of nodes and instances are what they are in the default mode, and nothing is fetched for them', async () => {
    const set = randomSet(seeded(4), 6, 16, MAP)
    const load = vi.spyOn(others, 'load')
    const cases = [face({}, new MeshToonMaterial({ normalMap: normalMap(2, MAP) }))]
    if (name !== 'webgl') {
      const material = new MeshStandardNodeMaterial()
      material.normalNode = vec3(0.3, 0.2, 0.93).normalize()
      cases.push(face({}, material))
    }
    for (const { shown, frames, wanted, wrinkles } of cases) {
      expect(largestDifference(await frames(), await wanted())).toBe(0)
      expect(shown).toMatchObject({ isComposed: false, isDual: false })
      expect(wrinkles.mode).toBe('auto')
    }
    const instanced = new InstancedMesh(new PlaneGeometry(), new MeshPhysicalMaterial(), 3)
    const wrinkles = new faces.harness.Wrinkles(instanced, set, { mode: 'auto' })
    expect(wrinkles.mode).toBe('auto')
    wrinkles.dispose()
    expect(load).not.toHaveBeenCalled()
    load.mockRestore()
  })

  it('modes that are set, copies and disposal find the material as it was', async () => {
    const { wrinkles, shown, picture, composed, wanted, material, mesh } = face()
    const own = material.normalMap
    await composed()
    const { onAfterRender } = mesh
    expect(wrinkles.cloneMaterial()).toMatchObject({ normalMap: own })
    await composed()
    wrinkles.mode = 'default'
    expect(mesh.onAfterRender).not.toBe(onAfterRender)
    expect(largestDifference(await picture(), await wanted())).toBe(0)
    wrinkles.mode = 'composed'
    expect(material.normalMap).not.toBe(own)
    wrinkles.mode = 'auto'
    expect(material.normalMap).toBe(own)
    await composed()
    wrinkles.mode = 'off'
    await picture()
    expect(shown.isComposed).toBe(false)
    wrinkles.mode = 'auto'
    await composed()
    wrinkles.dispose()
    expect(material.normalMap).toBe(own)
    await picture()
    expect(shown.isComposed).toBe(false)
  })
})

it.each(RENDERERS)(
  'a still face is drawn by the own program of its material on %s, unless other meshes have that',
  async (name) => {
    const harness = await createHarness(name)
    const { wrinkles, material, mesh, scene, picture, composed } = faceOf(harness)
    const shaderOf = watchShaders(harness)
    // Shaders of pages are kept here, which refer to themselves.
    material.userData.self = material.userData
    await picture()
    const edited = shaderOf(mesh)
    expect(edited).not.toBe('')
    await composed()
    const plain = new MeshPhysicalMaterial({ normalMap: material.normalMap, roughness: 0.6 })
    const other = new Mesh(mesh.geometry, plain)
    scene.add(other)
    await picture()
    const own = shaderOf(mesh)
    expect(own).not.toBe(edited)
    expect(own).toBe(shaderOf(other))
    // As the loader does for meshes that a page makes with the material.
    other.material = material as MeshPhysicalMaterial
    other.onBeforeRender = (renderer, _, camera) => wrinkles.prepare(renderer, camera, other)
    await picture()
    expect(shaderOf(other)).toBe(edited)
    other.material = plain
    await composed()
    await picture()
    expect(shaderOf(mesh)).toBe(own)
    wrinkles.setActivation('area0', 0.9)
    await picture()
    expect(shaderOf(mesh)).not.toBe(own)
    other.material = material as MeshPhysicalMaterial
    await composed()
    await picture()
    expect(shaderOf(mesh)).toBe(edited)
    for (const used of [wrinkles, plain, harness]) used.dispose()
  },
)

it.each(RENDERERS)(
  'a face that moves and holds still in turns is compiled once on %s, beside what the page compiles',
  async (name) => {
    const harness = await createHarness(name)
    const { renderer } = harness
    const { wrinkles, scene, composed, mesh, shown: face } = faceOf(harness)
    renderer.setSize(MAP, MAP, false)
    const pages: Promise<unknown>[] = []
    while (pages.length < 5 * FRAMES && !face.isComposed) {
      renderer.render(scene, squareCamera())
      const material = new MeshPhysicalMaterial({ normalMap: normalMap(3, MAP) })
      const key = `page ${pages.length}`
      material.customProgramCacheKey = () => key
      pages.push(renderer.compileAsync(square(material), squareCamera(), scene))
      await drawn(harness)
    }
    await Promise.all(pages)
    expect(face.isComposed).toBe(true)
    const shaderOf = watchShaders(harness)
    const shown = () => {
      renderer.render(scene, squareCamera())
      return shaderOf(mesh)
    }
    const still = shown()
    const builds = countBuilds(harness)
    for (let i = 0; i < 3; i++) {
      wrinkles.setActivation('area0', 0.9 - 0.2 * i)
      expect(shown()).not.toBe(still)
      await composed()
      expect(shown()).toBe(still)
    }
    expect(builds()).toBe(0)
    for (const used of [wrinkles, harness]) used.dispose()
  },
)

it.each(RENDERERS)(
  'a still face that casts shadows keeps its wrinkles on %s, whose maps are drawn during its own draw',
  async (name) => {
    const harness = await createHarness(name)
    const { wrinkles, scene, composed, picture, wanted, mesh } = faceOf(harness)
    mesh.castShadow = mesh.receiveShadow = true
    scene.getObjectByProperty('isDirectionalLight', true)!.castShadow = true
    harness.renderer.shadowMap.enabled = true
    await composed()
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    await composed()
    const shaderOf = watchShaders(harness)
    await picture()
    const still = shaderOf(mesh)
    wrinkles.setActivation('area0', 0.9)
    await picture()
    expect(shaderOf(mesh)).not.toBe(still)
    for (const used of [wrinkles, harness]) used.dispose()
  },
)

it('a page that draws to a target on WebGPURenderer finds that as it left it, and the default mode there', async () => {
  const harness = await createHarness('webgpu')
  const { picture, frames, composed, mesh, wrinkles } = faceOf(harness)
  const shaderOf = watchShaders(harness)
  await picture()
  const edited = shaderOf(mesh)
  await frames(2 * FRAMES)
  expect(shaderOf(mesh)).toBe(edited)
  expect(harness.renderer.getRenderTarget()).toBe(null)
  await composed()
  expect(harness.renderer.getRenderTarget()).toBe(null)
  for (const used of [wrinkles, harness]) used.dispose()
})

it('a face in the mode auto that two renderers draw in turns is right in both', async () => {
  const [harness, other] = [await createHarness('webgl'), await createHarness('webgl')]
  const { picture, composed, wanted, scene, wrinkles } = faceOf(harness)
  const expected = await wanted()
  await composed()
  for (let i = 0; i < 3; i++) {
    expect(largestDifference(await picture(), expected)).toBeLessThanOrEqual(UNSEEN)
    const there = await other.renderBytes(scene, squareCamera(), MAP)
    expect(largestDifference(there, expected)).toBeLessThanOrEqual(UNSEEN)
  }
  wrinkles.dispose()
  for (const { dispose } of [harness, other]) dispose()
})

it('the mode auto remains when a WebGL context is restored', async () => {
  const harness = await createHarness('webgl')
  const { picture, composed, wanted, wrinkles } = faceOf(harness)
  const expected = await wanted()
  await composed()
  await loseContext(harness, () => {})
  expect(largestDifference(await picture(), expected)).toBeLessThanOrEqual(UNSEEN)
  await composed()
  expect(largestDifference(await picture(), expected)).toBeLessThanOrEqual(UNSEEN)
  wrinkles.dispose()
  harness.dispose()
})

/** Returns a function that tells how many shaders were built since. */
function countBuilds(harness: Harness): () => number {
  const { renderer } = harness
  const before = harness.programs()
  if ('isWebGLRenderer' in renderer) return () => harness.programs() - before
  const backend = (renderer as WebGPURenderer).backend as unknown as { createNodeBuilder(): void }
  const build = vi.spyOn(backend, 'createNodeBuilder')
  return () => Math.max(build.mock.calls.length, harness.programs() - before)
}
