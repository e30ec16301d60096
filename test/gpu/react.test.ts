import { Clone } from '@react-three/drei/core/Clone'
import { useGraph } from '@react-three/fiber'
import { WrinkleLoaderPlugin, type Wrinkles, wrinklesOf } from 'furrow/three'
import { createElement, type ReactNode } from 'react'
import * as THREE from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone } from 'three/addons/utils/SkeletonUtils.js'
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { harnessOn, squareCamera } from './harness.ts'
import { createReactScene, type ReactScene } from './react-root.ts'
import { wrinkledFile } from './wrinkled-file.ts'

const SIZE = 32

describe('a loaded face in React Three Fiber', () => {
  const harness = harnessOn('webgl')
  let react: ReactScene
  let scene: THREE.Scene
  let gltf: GLTF

  beforeAll(async () => {
    react = await createReactScene(harness, SIZE)
  })
  afterAll(async () => {
    await react.dispose()
  })
  beforeEach(async () => {
    const loader = new GLTFLoader().register((parser) => new WrinkleLoaderPlugin(parser))
    gltf = await loader.parseAsync((await wrinkledFile()).buffer, '')
  })
  afterEach(async () => {
    await show(null)
    for (const wrinkles of wrinklesOf(gltf)) wrinkles.dispose()
    vi.restoreAllMocks()
  })

  const show = async (children: ReactNode) => {
    scene = (await react.show(children)).scene
  }
  const picture = async () => {
    // A mesh that the page makes gets wrinkles in its second frame.
    await harness.render(scene, squareCamera(), SIZE)
    return harness.render(scene, squareCamera(), SIZE)
  }
  const shownMeshes = () => {
    return scene.getObjectsByProperty('isMesh', true) as THREE.Mesh[]
  }
  const move = (weight: number) => {
    for (const { morphTargetInfluences } of shownMeshes()) morphTargetInfluences?.fill(weight)
  }
  const loadedMeshes = () => gltf.scene.getObjectByName('face')!.children as THREE.Mesh[]

  /** Component like those that gltfjsx writes. */
  function Face({ file, own = false }: { file: GLTF; own?: boolean }) {
    const { nodes, materials } = useGraph(file.scene)
    const meshes = nodes.face.children as THREE.Mesh[]
    return createElement(
      'group',
      { dispose: null },
      meshes.map(({ name, geometry, morphTargetDictionary, morphTargetInfluences }) =>
        createElement('mesh', {
          key: name,
          name,
          geometry,
          material: materials.skin,
          morphTargetDictionary,
          morphTargetInfluences: own ? [...morphTargetInfluences!] : morphTargetInfluences,
        }),
      ),
    )
  }

  const WAYS: [string, () => ReactNode][] = [
    ['as JSX', () => createElement(Face, { file: gltf })],
    ['as JSX with weights of its own', () => createElement(Face, { file: gltf, own: true })],
    ['as a <primitive>', () => createElement('primitive', { object: gltf.scene })],
    ['as a <Clone>', () => createElement(Clone, { object: gltf.scene })],
    [
      'as a <Clone> with its own material',
      () => createElement(Clone, { object: gltf.scene, deep: 'materialsOnly' }),
    ],
  ]
  /** Deep clone, for which drei copies geometries and never disposes of them. */
  const DEEP: (typeof WAYS)[number] = [
    'as a deep <Clone>',
    () => createElement(Clone, { object: gltf.scene, deep: true }),
  ]

  it.each([...WAYS, DEEP])(
    'wrinkles %s as its blendshapes move, and frees everything',
    async (_, element) => {
      const warn = vi.spyOn(console, 'warn')
      await show(element())
      expect(shownMeshes()).toHaveLength(2)
      const rest = await picture()
      move(1)
      const moved = await picture()
      expect(moved).not.toEqual(rest)
      const faces = shownMeshes().map((mesh) => wrinklesOf(mesh) as Wrinkles)
      expect(faces.map((face) => face.getActivation('a'))).toEqual([1, 1])
      move(0)
      expect(await picture()).toEqual(rest)
      await show(null)
      for (const face of faces) expect(face.isDisposed).toBe(!wrinklesOf(gltf).includes(face))
      expect(warn.mock.calls.filter(([text]) => /wrinkle/i.test(text))).toEqual([])
    },
  )

  it('leaves no texture on the GPU, however often copies come and go', async () => {
    const { memory } = (harness.renderer as THREE.WebGLRenderer).info
    const mount = async () => {
      for (const [, element] of WAYS) {
        await show(element())
        move(1)
        await picture()
      }
      await show(null)
    }
    // The influence atlas creates its own geometry on first use, so mount twice before counting.
    for (let i = 0; i < 2; i++) await mount()
    const { textures, geometries } = memory
    for (let i = 0; i < 4; i++) await mount()
    expect([memory.textures, memory.geometries]).toEqual([textures, geometries])
    expect(loadedMeshes().map((mesh) => wrinklesOf(mesh))).toEqual(Array(2).fill(wrinklesOf(gltf)[0]))
  })

  it.each([
    ['<Clone> makes', () => createElement(Clone, { object: gltf.scene })],
    ['a page makes once', () => createElement(Face, { file: { scene: clone(gltf.scene) } as GLTF })],
  ])('wrinkles a copy of a face with a skeleton that %s, and frees everything', async (_, create) => {
    // With a skinned mesh in the scene, drei copies the complete scene by SkeletonUtils.
    const skinned = new THREE.SkinnedMesh()
    skinned.visible = false
    skinned.bind(new THREE.Skeleton([new THREE.Bone()]))
    gltf.scene.add(skinned)
    const element = create()
    for (let i = 0; i < 2; i++) {
      await show(element)
      move(1)
      // `useGraph` gives both meshes one material. The second mesh gets a copy, and wrinkles a frame later.
      for (let frame = 0; frame < 2; frame++) await picture()
      const meshes = shownMeshes().filter((mesh) => mesh.visible)
      const faces = meshes.map((mesh) => wrinklesOf(mesh) as Wrinkles)
      expect(faces.map((face) => face.getActivation('a'))).toEqual([1, 1])
      await show(null)
      expect(faces.map((face) => face.isDisposed)).toEqual([true, true])
    }
    expect(wrinklesOf(gltf)[0].isDisposed).toBe(false)
  })

  it('keeps two copies side by side independent', async () => {
    const copies = [-1, 1].map((x) =>
      createElement(Clone, { key: x, object: gltf.scene, position: [x, 0, 0] }),
    )
    await show(copies)
    const meshes = shownMeshes()
    expect(meshes).toHaveLength(4)
    for (const [i, mesh] of meshes.entries()) mesh.morphTargetInfluences = [i < 2 ? 1 : 0]
    await picture()
    expect(meshes.map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([1, 1, 0, 0])
  })
})
