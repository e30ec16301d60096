import { Clone } from '@react-three/drei/core/Clone'
import * as forWebGL from 'furrow/react'
import * as forWebGPU from 'furrow/react/webgpu'
import { wrinklesOf } from 'furrow/three'
import { createElement } from 'react'
import type { Mesh, Object3D } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, beforeAll, describe, expect, it, type MockInstance, vi } from 'vitest'
import { Frame } from '../../packages/furrow/src/runtime/frame.ts'
import type { InfluenceAtlas } from '../../packages/furrow/src/three/atlas/influence-atlas.ts'
import type { RendererFrame } from '../../packages/furrow/src/three/frame.ts'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { alive } from './alive.ts'
import { harnessOn } from './harness.ts'
import { createReactScene, type ReactScene } from './react-root.ts'
import { wrinkledFile } from './wrinkled-file.ts'

const SIZE = 16
const CYCLES = 30

describe.each(['webgl', 'webgpu'] as const)('components that are mounted and unmounted, %s', (name) => {
  const { extendLoader, useWrinkles, Wrinkles } = name === 'webgl' ? forWebGL : forWebGPU
  const harness = harnessOn(name)
  let react: ReactScene
  let gltf: GLTF
  let added: MockInstance
  let removed: MockInstance
  let frame: RendererFrame
  /** Number of faces in Furrow's frame loop, in addition to those before the first cycle. */
  let members = 0
  const made: WeakRef<object>[] = []
  const set = randomSet(seeded(3), 1, 16)

  beforeAll(async () => {
    react = await createReactScene(harness, SIZE)
    const loader = new GLTFLoader()
    extendLoader(loader)
    gltf = await loader.parseAsync((await wrinkledFile()).buffer, '')
    added = vi.spyOn(Frame.prototype, 'add')
    removed = vi.spyOn(Frame.prototype, 'remove')
  })
  afterAll(async () => {
    vi.restoreAllMocks()
    for (const wrinkles of wrinklesOf(gltf)) wrinkles.dispose()
    await react.dispose()
  })

  function Hooked() {
    useWrinkles(gltf, { activations: { c: 0.5 }, inputs: { age: 50 } })
    return createElement('primitive', { object: gltf.scene })
  }
  const page = () => [
    createElement(Hooked, { key: 'hook' }),
    createElement(
      Wrinkles,
      { key: 'clone', activations: { d: 0.75 } },
      createElement(Clone, { object: gltf.scene }),
    ),
    createElement(
      Wrinkles,
      { key: 'materials', inputs: { age: 70 } },
      createElement(Clone, { object: gltf.scene, deep: 'materialsOnly' }),
    ),
    createElement(
      'mesh',
      { key: 'set' },
      createElement('planeGeometry'),
      createElement('meshStandardMaterial'),
      createElement(Wrinkles, { set, activations: { [set.areas[0].name]: 0.5 } }),
    ),
  ]

  /** Mounts the components, draws, unmounts them and draws again. */
  const cycle = async () => {
    const { scene } = await react.show(page())
    const meshes = scene.getObjectsByProperty('isMesh', true) as Mesh[]
    for (const { morphTargetInfluences } of meshes) morphTargetInfluences?.fill(1)
    // A mesh that the page makes gets wrinkles in its second frame.
    await react.advance(2)
    const faces = new Set(meshes.map((mesh) => wrinklesOf(mesh)!))
    // Four faces: one of the file, which the first copy shares; two of meshes with separate materials; one of a wrinkle set.
    expect([...faces].filter((face) => !face.isDisposed)).toHaveLength(4)
    made.push(...[...faces, ...meshes].map((object) => new WeakRef<object>(object)))
    await react.show(null)
    await react.advance(1)
    expect([...faces].filter((face) => !face.isDisposed)).toHaveLength(1)
    frame = added.mock.contexts[0] as RendererFrame
    members += added.mock.calls.length - removed.mock.calls.length
    // A spy keeps its recorded arguments alive.
    added.mockClear()
    removed.mockClear()
  }
  const counts = async () => ({
    memory: { ...harness.renderer.info.memory },
    programs: harness.programs(),
    members,
    atlases: (frame.targets as InfluenceAtlas[]).map(({ cells }) => [cells.slots.size, { ...cells.grid }]),
    listeners: listenersOf(gltf.scene),
    objects: await alive(made),
  })

  it(`free everything in ${CYCLES} cycles`, async () => {
    for (let i = 0; i < 2; i++) await cycle()
    const first = await counts()
    for (let i = 2; i < CYCLES; i++) await cycle()
    expect(await counts()).toEqual(first)
    expect(first.members).toBe(0)
  })
})

/** Counts the event listeners of meshes, geometries and materials. */
function listenersOf(root: Object3D): number {
  let count = 0
  root.traverse((object) => {
    const { geometry, material } = object as Mesh
    for (const target of [object, geometry, material]) {
      const { _listeners } = (target ?? {}) as { _listeners?: Record<string, unknown[]> }
      for (const list of Object.values(_listeners ?? {})) count += list.length
    }
  })
  return count
}
