import { VRMLoaderPlugin } from '@pixiv/three-vrm'
import { MToonMaterial } from '@pixiv/three-vrm-materials-mtoon'
import { wrinklesOf } from 'furrow/three'
import { AmbientLight, BackSide, Color, type Material, Mesh, Vector3 } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone as cloneSkinned } from 'three/addons/utils/SkeletonUtils.js'
import { expect, it, vi } from 'vitest'
import { createHarness, squareCamera } from '../harness.ts'
import { vrmFile } from '../vrm-file.ts'
import { ball, heightSet, sceneOf, sideCamera } from './ball.ts'
import { differing, FEW } from './differing.ts'
import { displacedMesh } from './displaced-ball.ts'

const white = { color: new Color(1, 1, 1), shadeColorFactor: new Color(1, 1, 1) }

it.each([
  ['', false],
  [', whose second material is its outline', true],
])('an MToon face has relief%s', async (_, hasOutline) => {
  const warn = vi.spyOn(console, 'warn')
  const harness = await createHarness('webgl')
  const mesh = ball() as Mesh<Mesh['geometry'], Material | Material[]>
  const mtoon = new MToonMaterial(white as never)
  mesh.material = mtoon
  if (hasOutline) {
    mesh.material = [mtoon, new MToonMaterial({ ...white, isOutline: true } as never)]
    const { count } = mesh.geometry.index!
    mesh.geometry.addGroup(0, count, 0)
    mesh.geometry.addGroup(0, count, 1)
  }
  const scene = sceneOf(mesh as Mesh).add(new AmbientLight(0xffffff, 5))
  const picture = async () => {
    for (let i = 0; i < 3; i++) await harness.renderBytes(scene, sideCamera(0.15), 256)
    return silhouette(await harness.renderBytes(scene, sideCamera(0.15), 256))
  }
  const plain = await picture()
  const wrinkles = new harness.Wrinkles(mesh as Mesh, heightSet(), { relief: 'on' })
  await wrinkles.reliefReady()
  const shown = await picture()
  const expected = silhouette(
    await harness.renderBytes(sceneOf(displacedMesh(ball())), sideCamera(0.15), 256),
  )
  expect(wrinkles.mode).toBe('default')
  expect(differing(shown, expected)).toBeLessThan(FEW)
  expect(differing(shown, plain)).toBeGreaterThan(100)
  wrinkles.dispose()
  expect(differing(await picture(), plain)).toBe(0)
  expect(warn.mock.calls.filter(([text]) => /^Wrinkles/.test(text))).toEqual([])
  harness.dispose()
})

it("the MToon outline follows the relief, keeps the page's width, and is shared by copies", async () => {
  const harness = await createHarness('webgl')
  const mesh = ball() as Mesh<Mesh['geometry'], Material[]>
  const outline = new MToonMaterial({
    ...white,
    isOutline: true,
    side: BackSide,
    outlineWidthMode: 'worldCoordinates',
    outlineColorFactor: new Color(1, 1, 1),
    outlineLightingMixFactor: 0,
  } as never)
  mesh.material = [new MToonMaterial(white as never), outline]
  const { count } = mesh.geometry.index!
  mesh.geometry.addGroup(0, count, 0)
  mesh.geometry.addGroup(0, count, 1)
  const other = Object.assign(ball(), { material: outline })
  other.position.x = 1
  const scene = sceneOf(mesh as Mesh, other).add(new AmbientLight(0xffffff, 5))
  const wrinkles = new harness.Wrinkles(mesh as Mesh, heightSet(), { relief: 'on' })
  await wrinkles.reliefReady()
  for (const width of [0.004, 0.001]) {
    outline.outlineWidthFactor = width
    for (let i = 0; i < 3; i++) await harness.renderBytes(scene, sideCamera(0.15), 256)
    const shown = silhouette(await harness.renderBytes(scene, sideCamera(0.15), 256))
    const expected = sceneOf(widened(displacedMesh(ball()), width))
    expect(
      differing(shown, silhouette(await harness.renderBytes(expected, sideCamera(0.15), 256))),
    ).toBeLessThan(FEW)
  }
  expect(mesh.children).toHaveLength(2)
  wrinkles.dispose()
  expect(mesh.children).toEqual([])
  const hooks = [mesh.onBeforeShadow, mesh.onAfterShadow, mesh.onAfterRender]
  expect(hooks).toEqual([
    Mesh.prototype.onBeforeShadow,
    Mesh.prototype.onAfterShadow,
    Mesh.prototype.onAfterRender,
  ])
  harness.dispose()
})

it('an avatar loaded by three-vrm, and its copy, have outlines around their relief', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
  const harness = await createHarness('webgl')
  const file = await vrmFile(true, ({ layers: [layer] }) =>
    Object.assign(layer, { heightTexture: { index: 2, amplitude: 0.05 } }),
  )
  const loader = new GLTFLoader()
    .register((parser) => new VRMLoaderPlugin(parser))
    .register((parser) => new harness.Plugin(parser, { relief: 'on' }))
  const gltf = await loader.parseAsync(file.slice().buffer, '')
  const copy = cloneSkinned(gltf.scene)
  for (const root of [gltf.scene, copy]) {
    const scene = sceneOf(root as never).add(new AmbientLight(0xffffff, 5))
    await harness.renderBytes(scene, squareCamera(), 32)
    const meshes = root.getObjectsByProperty('isMesh', true) as Mesh[]
    await wrinklesOf(meshes[0])!.reliefReady()
    for (let i = 0; i < 3; i++) await harness.renderBytes(scene, squareCamera(), 32)
    const dense: Mesh[] = []
    root.traverse((object) => 'isReliefMesh' in object && dense.push(object as unknown as Mesh))
    const outlines = dense.filter(({ material }) => (material as MToonMaterial).isOutline)
    expect([dense.length, outlines.length]).toEqual([4, 2])
    expect(dense.every(({ geometry }) => geometry.drawRange.count > 3)).toBe(true)
  }
  const lines = warn.mock.calls
    .flat()
    .filter((text) => /Wrinkles/.test(text) && !/triangles are longer/.test(text))
  expect(lines).toEqual([])
  harness.dispose()
})

/** Returns a copy of a mesh with every vertex moved away from the origin by `width` metres. */
function widened(mesh: Mesh, width: number): Mesh {
  const { position } = mesh.geometry.attributes
  const point = new Vector3()
  for (let i = 0; i < position.count; i++) {
    point.fromBufferAttribute(position, i)
    position.setXYZ(i, ...point.setLength(point.length() + width).toArray())
  }
  return mesh
}

/** Returns a picture in which every drawn pixel is white. */
function silhouette(pixels: Uint8Array): Uint8Array {
  return pixels.map((_, i) => (pixels[i - (i % 4) + 1] > 8 ? 255 : 0))
}
