import { wrinklesOf } from 'furrow/three'
import { AmbientLight, type BufferGeometry, Mesh, type MeshStandardMaterial, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { describe, expect, it } from 'vitest'
import { alive } from '../alive.ts'
import { createHarness, type Harness, squareCamera } from '../harness.ts'
import { wrinkledFile } from '../wrinkled-file.ts'

const LOADS = 40

describe.each(['webgl', 'webgpu'] as const)('files that come and go, %s', (name) => {
  it(`leave nothing behind in ${LOADS} loads and disposes`, async () => {
    const harness = await createHarness(name)
    const file = await wrinkledFile()
    const made: WeakRef<object>[] = []
    const counts = () => ({ memory: { ...harness.renderer.info.memory }, programs: harness.programs() })
    for (let i = 0; i < 2; i++) made.push(...(await loadAndDispose(harness, file)))
    const first = counts()
    for (let i = 2; i < LOADS; i++) made.push(...(await loadAndDispose(harness, file)))
    expect(counts()).toEqual(first)
    // Those of a few files are still held on WebGPU, however many were loaded.
    expect(await alive(made)).toBeLessThan(made.length / 4)
    harness.dispose()
  })
})

/** Loads a face, shows its wrinkles, and disposes of all that it has. */
async function loadAndDispose(harness: Harness, file: Uint8Array<ArrayBuffer>): Promise<WeakRef<object>[]> {
  const loader = new GLTFLoader().register((parser) => new harness.Plugin(parser))
  const gltf = await loader.parseAsync(file.slice().buffer, '')
  const meshes: Mesh<BufferGeometry, MeshStandardMaterial>[] = []
  gltf.scene.traverse((object) => object instanceof Mesh && meshes.push(object))
  for (const { morphTargetInfluences } of meshes) morphTargetInfluences!.fill(1)
  await harness.renderBytes(new Scene().add(gltf.scene, new AmbientLight()), squareCamera(), 8)
  const [face] = wrinklesOf(gltf)
  expect(face.getActivation('a')).toBe(1)
  face.dispose()
  for (const { geometry, material } of meshes) {
    geometry.dispose()
    material.normalMap!.dispose()
    material.dispose()
  }
  return [face, ...meshes].map((object) => new WeakRef<object>(object))
}
