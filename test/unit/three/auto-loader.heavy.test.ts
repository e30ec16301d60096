import { readFileSync } from 'node:fs'
import { readWrinkleMaps, wrinklesOf, wrinklesReady } from 'furrow/three'
import type { Bone, Mesh } from 'three'
import { expect, it, vi } from 'vitest'
import { Workshop } from '../cli/workshop.ts'
import { loadAuto, plainModel } from './auto-character.ts'
import { FakeWorker } from './fake-worker.ts'
import { loadInNode } from './node-loader.ts'
import { frameOf } from './stub-renderer.ts'

const at = new Workshop()
/** The folds of a shirt take half a minute. */
const PATIENCE = 600_000

it.each(['body', 'human'])(
  'a page makes the same wrinkles for %s as the command',
  async (name) => {
    const bytes = plainModel(name)
    await at.run('auto', at.write('plain.glb', bytes), '-o', at.path('out.glb'), '--size', '512', '--force')
    const expected = await readWrinkleMaps(await loadInNode(readFileSync(at.path('out.glb'))))
    const steps: [number, number][] = []
    const warn = vi.spyOn(console, 'warn')
    FakeWorker.parts.length = 0
    const progress = (done: number, total: number) => steps.push([done, total])
    const made = await wrinklesReady(await loadAuto(bytes, { size: 512, progress }))
    expect(warn).not.toHaveBeenCalled()

    const names = made.map(({ mesh }) => mesh.name)
    expect([...names].sort()).toEqual(expected.map(({ meshes: [mesh] }) => mesh.name).sort())
    if (name === 'body') expect(names.slice(1)).toEqual(['trousers', 'shirt', 'hands'])
    for (const { meshes, set, drivers } of expected) {
      const index = names.indexOf(meshes[0].name)
      const { areas, normals, ...part } = FakeWorker.parts[index]!
      expect(made[index]!.areaNames).toEqual(set.areas.map((area) => area.name))
      // JSON does not keep the sign of 0.
      expect(JSON.parse(JSON.stringify(part.drivers))).toEqual(drivers)
      for (const [i, { weights }] of set.areas.entries()) expect(areas[i]!.weights).toMatchObject(weights)
      const texels = normals.data.length / normals.depth
      for (const [i, { normal }] of set.layers.entries()) {
        const own = normals.data.subarray(i * texels, (i + 1) * texels)
        expect(Buffer.compare(own, (normal as { data: Uint8Array }).data)).toBe(0)
      }
    }
    // Progress covers all meshes.
    expect(steps.at(0)).toEqual([0, 5 * names.length])
    expect(steps.at(-1)).toEqual([5 * names.length, 5 * names.length])
    expect(steps.map(([done]) => done)).toEqual(steps.map(([done]) => done).sort((a, b) => a - b))
  },
  PATIENCE,
)

it('bones of the page drive the wrinkles of each mesh, and other meshes with the material stay plain', async () => {
  const bytes = plainModel('hand', ({ meshes, materials }) => {
    meshes[0].name = 'Thing'
    materials[0].name = ''
    meshes[1].primitives[0].material = 0
  })
  const gltf = await loadAuto(bytes, { size: 256, kinds: { Thing: 'skin' } })
  const [wrinkles] = await wrinklesReady(gltf)
  const cuff = gltf.scene.getObjectByName('cuff') as Mesh
  expect(cuff.material).not.toBe(wrinkles!.mesh.material)
  expect(wrinklesOf(cuff)).toBeUndefined()
  const bend = 'finger2-2.L flexion'
  frameOf(wrinkles!.mesh)()
  const rest = wrinkles!.getActivation(bend)
  const bone = gltf.scene.getObjectByName('finger2-2L') as Bone
  bone.rotateX(1)
  gltf.scene.updateMatrixWorld(true)
  frameOf(wrinkles!.mesh)()
  expect(wrinkles!.getActivation(bend)).toBeGreaterThan(rest + 0.2)
})

it('a page that aborts keeps the meshes that are finished', async () => {
  const warn = vi.spyOn(console, 'warn')
  // Two nodes show the hand, with different materials.
  const bytes = plainModel('hand', ({ meshes, materials, nodes, scenes }) => {
    const node = nodes.findIndex(({ mesh }: { mesh?: number }) => mesh === 0)
    const primitives = meshes[0].primitives.map((primitive: object) => ({
      ...primitive,
      material: materials.length,
    }))
    materials.push({ ...materials[0], name: 'other skin' })
    scenes[0].nodes.push(nodes.length)
    nodes.push({ ...nodes[node], name: 'other', mesh: meshes.length })
    meshes.push({ name: 'other', primitives })
  })
  const controller = new AbortController()
  const progress = (done: number) => {
    if (done > 6) controller.abort()
  }
  const gltf = await loadAuto(bytes, { size: 256, signal: controller.signal, progress })
  expect((await wrinklesReady(gltf)).map(({ mesh }) => mesh.name)).toEqual(['skin'])
  expect(warn).not.toHaveBeenCalled()
})
