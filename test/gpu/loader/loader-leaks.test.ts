import { wrinklesOf } from 'furrow/three'
import { type BufferGeometry, DirectionalLight, Mesh, type MeshStandardMaterial, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone } from 'three/addons/utils/SkeletonUtils.js'
import { describe, expect, it } from 'vitest'
import { alive } from '../alive.ts'
import { createHarness, type Harness, squareCamera } from '../harness.ts'
import { wrinkledFile } from '../wrinkled-file.ts'

const LOADS = 40
const SIZE = 8

type Face = Mesh<BufferGeometry, MeshStandardMaterial>

/** Makes a file whose layer has heights. */
const fileWithHeights = () =>
  wrinkledFile(({ layers: [layer] }) =>
    Object.assign(layer, { heightTexture: { index: 2, amplitude: 0.05 } }),
  )

/** Creates a camera that sees only a few millimetres, so that even the lowest relief is drawn. */
function close() {
  const camera = squareCamera()
  camera.zoom = 200
  camera.updateProjectionMatrix()
  return camera
}

describe.each(['webgl', 'webgpu'] as const)('files that are loaded and disposed of, %s', (name) => {
  it.each([
    ['with wrinkles.dispose()', wrinkledFile, { disposes: true }],
    ['with geometry and material alone', wrinkledFile, {}],
    ['with geometry and material alone, of clones too', wrinkledFile, { clones: 2 }],
    ['with geometry and material alone, and relief', fileWithHeights, { relief: true }],
    [
      'with geometry and material alone, and relief of clones too',
      fileWithHeights,
      { relief: true, clones: 1 },
    ],
  ] as const)(`free everything in ${LOADS} loads and disposals %s`, async (_, makeFile, options) => {
    const harness = await createHarness(name)
    const file = await makeFile()
    const made: WeakRef<object>[] = []
    const counts = () => ({ memory: { ...harness.renderer.info.memory }, programs: harness.programs() })
    for (let i = 0; i < 2; i++) made.push(...(await loadAndDispose(harness, file, options)))
    const first = counts()
    for (let i = 2; i < LOADS; i++) made.push(...(await loadAndDispose(harness, file, options)))
    expect(counts()).toEqual(first)
    // On WebGPU three.js keeps up to 15 objects of recent files, independently of the number of loads.
    expect(await alive(made)).toBeLessThan(made.length / 4)
    harness.dispose()
  })

  it.each([
    ['default', {}],
    ['composed', { mode: 'composed' }],
    ['paper', { mode: 'paper' }],
  ] as const)('show their wrinkles again if drawn after a disposal, %s', async (_, options) => {
    const harness = await createHarness(name)
    const { scene, meshes } = await load(harness, await wrinkledFile(), options)
    const draw = () => harness.renderBytes(scene, squareCamera(), SIZE)
    await draw()
    const before = await draw()
    for (const mesh of meshes) disposeOf(mesh)
    await draw()
    expect(await draw()).toEqual(before)
    for (const { morphTargetInfluences } of meshes) morphTargetInfluences!.fill(0)
    expect(await draw()).not.toEqual(before)
    harness.dispose()
  })

  it('keep resources that a clone still shows', async () => {
    const harness = await createHarness(name)
    const { gltf, scene, meshes } = await load(harness, await wrinkledFile())
    const copy = clone(gltf.scene)
    scene.add(copy)
    const draw = () => harness.renderBytes(scene, squareCamera(), SIZE)
    gltf.scene.visible = false
    for (let i = 0; i < 3; i++) await draw()
    const before = await draw()
    for (const mesh of meshes) disposeOf(mesh)
    expect(await draw()).toEqual(before)
    harness.dispose()
  })
})

interface LoadOptions {
  /** Whether to call `dispose` of the wrinkles. */
  disposes?: boolean
  relief?: boolean
  clones?: number
}

/** Loads a face, draws its wrinkles, and disposes of its geometries and materials. Returns references to detect leaks. */
async function loadAndDispose(
  harness: Harness,
  file: Uint8Array<ArrayBuffer>,
  { disposes = false, relief = false, clones = 0 }: LoadOptions,
): Promise<WeakRef<object>[]> {
  const { gltf, scene, meshes } = await load(harness, file)
  for (let i = 0; i < clones; i++) scene.add(clone(gltf.scene))
  const camera = relief ? close() : squareCamera()
  const draw = () => harness.renderBytes(scene, camera, SIZE)
  for (let i = 0; i < 3; i++) await draw()
  const faces = new Set(facesIn(scene).map((mesh) => wrinklesOf(mesh)!))
  // The two meshes of the file share their wrinkles. In a clone each mesh has its own.
  expect(faces.size).toBe(1 + 2 * clones)
  for (const face of faces) {
    expect(face.getActivation('a')).toBe(1)
    if (!relief) continue
    face.relief = 'on'
    await face.reliefReady()
  }
  await draw()
  for (const face of faces) if (disposes) face.dispose()
  const drawn = facesIn(scene)
  for (const mesh of new Set([...meshes, ...drawn])) disposeOf(mesh)
  return [...faces, ...drawn].map((object) => new WeakRef<object>(object))
}

async function load(harness: Harness, file: Uint8Array<ArrayBuffer>, options: object = {}) {
  const loader = new GLTFLoader().register((parser) => new harness.Plugin(parser, options))
  const gltf = await loader.parseAsync(file.slice().buffer, '')
  const scene = new Scene().add(gltf.scene, new DirectionalLight())
  const meshes = facesIn(scene)
  for (const { morphTargetInfluences } of meshes) morphTargetInfluences!.fill(1)
  return { gltf, scene, meshes }
}

/** Lists the meshes with wrinkles in a scene, without the meshes that draw relief. */
function facesIn(scene: Scene): Face[] {
  const meshes: Face[] = []
  scene.traverse((object) => object instanceof Mesh && wrinklesOf(object) && meshes.push(object))
  return meshes
}

function disposeOf({ geometry, material }: Face): void {
  geometry.dispose()
  material.normalMap?.dispose()
  material.dispose()
}
