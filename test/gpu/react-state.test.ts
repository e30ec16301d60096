import { Clone } from '@react-three/drei/core/Clone'
import { extendLoader, useWrinkles, type WrinkleState, Wrinkles } from 'furrow/react'
import { setDrivers, type WrinklesBase, wrinklesOf } from 'furrow/three'
import { createElement, type ReactNode } from 'react'
import { type Mesh, MeshStandardMaterial, PlaneGeometry, type WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn } from './harness.ts'
import { createReactScene, type ReactScene } from './react-root.ts'
import { faceMeshes, wrinkledFile } from './wrinkled-file.ts'

const SIZE = 16

describe('the state of wrinkles in React', () => {
  const harness = harnessOn('webgl')
  let react: ReactScene
  let gltf: GLTF
  let face: WrinklesBase

  beforeAll(async () => {
    react = await createReactScene(harness, SIZE)
  })
  afterAll(async () => {
    await react.dispose()
  })
  beforeEach(async () => {
    const loader = new GLTFLoader()
    // Furrow's hook calls `extendLoader` again for each file.
    for (let i = 0; i < 2; i++) extendLoader(loader)
    gltf = await loader.parseAsync((await wrinkledFile()).buffer, '')
    face = wrinklesOf(gltf)[0]
  })
  afterEach(async () => {
    await react.show(null)
    face.dispose()
    vi.restoreAllMocks()
  })

  function Hooked({ state }: { state?: WrinkleState }) {
    useWrinkles(gltf, state)
    return createElement('primitive', { object: gltf.scene })
  }
  const WAYS: [string, (state: WrinkleState) => ReactNode][] = [
    ['by useWrinkles', (state) => createElement(Hooked, { state })],
    [
      'by <Wrinkles> round a <primitive>',
      (state) => createElement(Wrinkles, state, createElement('primitive', { object: gltf.scene })),
    ],
    [
      'by <Wrinkles> in a <primitive>',
      (state) => createElement('primitive', { object: gltf.scene }, createElement(Wrinkles, state)),
    ],
  ]
  const shown = () => ({
    activations: face.areaNames.map((name) => face.getActivation(name)),
    age: face.inputs.get('age'),
    mode: face.mode,
    relief: face.relief,
  })
  const REST = { activations: [0, 0.25, 0, 0], age: 0, mode: 'default', relief: 'near' }

  it('belongs to one face, however often the loader is extended', () => {
    expect(wrinklesOf(gltf)).toHaveLength(1)
  })

  it.each(WAYS)('is set %s, follows its properties, and ends with the component', async (_, element) => {
    await react.show(
      element({ activations: { c: 0.5, none: 1 }, inputs: { age: 50 }, mode: 'composed', relief: 'off' }),
    )
    await react.advance(2)
    const all = { activations: [0, 0.25, 0.5, 0], age: 50, mode: 'composed', relief: 'off' }
    expect(shown()).toEqual(all)
    await react.show(element({ activations: { b: 1, d: 0.75 }, inputs: { age: 60 } }))
    await react.advance(2)
    expect(shown()).toEqual({ ...REST, activations: [0, 1, 0, 0.75], age: 60 })
    await react.show(null)
    await react.advance(1)
    face.update()
    expect(shown()).toEqual(REST)
    expect(face.isDisposed).toBe(false)
  })

  it.each(WAYS)(
    'plays expressions %s over several frames, and then releases the blendshapes',
    async (_, element) => {
      const expression = (name: string, ...targets: { name: string; weight: number }[]) => ({
        type: 'expression',
        name,
        targets,
        activations: [],
      })
      const expressions = [expression('rest'), expression('raised', { name: 'browInnerUp', weight: 1 })]
      setDrivers(face, [...face.drivers.filter(({ type }) => type !== 'expression'), ...expressions])
      const brows = () => (gltf.scene.getObjectByName('face')!.children[0] as Mesh).morphTargetInfluences![0]
      await react.show(element({}))
      await react.advance(1)
      for (const mesh of faceMeshes(gltf.scene)) mesh.morphTargetInfluences![0] = 0.5
      await react.advance(3)
      expect(brows()).toBe(0.5)
      await react.show(element({ expression: 'raised' }))
      await react.advance(2)
      expect(brows()).toBeGreaterThan(0.5)
      expect(brows()).toBeLessThan(1)
      await react.advance(3)
      expect(brows()).toBe(1)
      face.update()
      expect(face.getActivation('a')).toBe(1)
      await react.show(element({ expression: { raised: 0.25 } }))
      await react.advance(5)
      expect(brows()).toBeCloseTo(0.25)
      await react.show(null)
      expect(brows()).toBe(0)
    },
  )

  it('is separate for each copy of a face', async () => {
    const copy = (age: number) =>
      createElement(
        Wrinkles,
        { key: age, inputs: { age } },
        createElement(Clone, { object: gltf.scene, deep: 'materialsOnly' }),
      )
    const { scene } = await react.show([copy(30), copy(70)])
    await react.advance(4)
    const meshes = scene.getObjectsByProperty('isMesh', true) as Mesh[]
    const ages = meshes.map((mesh) => wrinklesOf(mesh)!.inputs.get('age'))
    expect(new Set(ages)).toEqual(new Set([30, 70]))
    expect(face.inputs.get('age')).toBe(0)
  })

  it('ignores names that a face lacks, with one warning, and applies the rest', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const state = {
      mode: 'fancy' as never,
      inputs: { age: NaN, stress: 0.5 },
      expression: 'unknown',
      activation: { c: 1 },
    }
    await react.show(createElement(Hooked, { state }))
    await react.advance(5)
    await react.show(createElement(Hooked, { state: { ...state } }))
    await react.advance(5)
    expect(face.inputs.get('stress')).toBe(0.5)
    const texts = warn.mock.calls.map(([text]) => String(text))
    for (const fault of [
      /invalid mode, got "fancy"/,
      /"age" is NaN/,
      /expression.*got "unknown"/,
      /unknown option, got "activation".*did you mean "activations"/,
    ]) {
      expect(
        texts.filter((text) => fault.test(text)),
        String(fault),
      ).toHaveLength(1)
    }
  })

  it('adds a set to a mesh, and removes it with the component', async () => {
    const material = new MeshStandardMaterial()
    const geometry = new PlaneGeometry()
    const set = randomSet(seeded(3), 1, 16)
    const [{ name }] = set.areas
    const element = (child: ReactNode) => createElement('mesh', { geometry, material }, child)
    const { scene } = await react.show(
      element(createElement(Wrinkles, { set, activations: { [name]: 0.5 } })),
    )
    await react.advance(2)
    const mesh = scene.getObjectByProperty('isMesh', true) as Mesh
    const own = wrinklesOf(mesh)!
    expect(own.getActivation(name)).toBe(0.5)
    await react.show(element(null))
    expect([own.isDisposed, wrinklesOf(mesh)]).toEqual([true, undefined])
  })

  it('adds no wrinkles to an unsuitable mesh, and logs one warning', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const broken = createElement(Wrinkles, { set: { layers: [], areas: [] } })
    await react.show(createElement('mesh', null, createElement('planeGeometry'), broken))
    await react.advance(2)
    expect(warn.mock.calls.length).toBeGreaterThan(0)
    for (const [text] of warn.mock.calls) expect(text).toMatch(/^Wrinkles: /)
  })

  it('changes only the expression of a face without wrinkles', async () => {
    const plain = await new GLTFLoader().parseAsync((await wrinkledFile()).buffer, '')
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const state: WrinkleState = { activations: { a: 1 }, inputs: { age: 70 }, mode: 'composed' }
    const element = (own: WrinkleState) =>
      createElement(Wrinkles, own, createElement('primitive', { object: plain.scene }))
    await react.show(element(state))
    await react.advance(2)
    expect(warn).not.toHaveBeenCalled()
    await react.show(element({ ...state, expression: 'surprised' }))
    await react.advance(5)
    const [mesh] = faceMeshes(plain.scene)
    expect(mesh.morphTargetInfluences![0]).toBeGreaterThan(0.5)
    expect(warn.mock.calls.map(([text]) => String(text))).toEqual([
      expect.stringMatching(/lacks blendshapes/),
    ])
  })

  it('frees everything after a hundred mounts', async () => {
    const { memory } = (harness.renderer as WebGLRenderer).info
    const mount = async () => {
      for (const [, element] of WAYS) {
        await react.show(element({ activations: { c: 1 }, expression: 'surprised' }))
        await react.advance(2)
        await react.show(null)
      }
    }
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    await mount()
    const { textures, geometries } = memory
    for (let i = 0; i < 33; i++) await mount()
    expect([memory.textures, memory.geometries]).toEqual([textures, geometries])
  })

  it("takes the loader's options", async () => {
    const loader = new GLTFLoader()
    extendLoader(loader, { mode: 'composed' })
    const file = await loader.parseAsync((await wrinkledFile()).buffer, '')
    expect(wrinklesOf(file)[0].mode).toBe('composed')
    wrinklesOf(file)[0].dispose()
  })
})
