import type { Document } from '@gltf-transform/core'
import {
  WrinkleLoaderPlugin as WebGLPlugin,
  type WrinklesBase,
  wrinklesOf,
  wrinklesReady,
} from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin } from 'furrow/webgpu'
import { DirectionalLight, type Mesh, type Object3D, OrthographicCamera, Scene } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { largestDifference, ROUNDING } from '../difference.ts'
import { harnessOn, RENDERERS } from '../harness.ts'
import {
  bareSheet,
  HALF,
  makeUnlit,
  moveNames,
  quantise,
  scaleNode,
  showTwice,
  splitInTwo,
  stillTarget,
  withoutIndex,
  withoutTargets,
} from './bare-sheet.ts'

const SIZE = 64
const AUTO = { size: 256, areaSize: 32 }

describe.each(RENDERERS)('a file without wrinkles on %s', (name) => {
  const harness = harnessOn(name)
  beforeEach(forgetAll)
  afterEach(() => {
    vi.restoreAllMocks()
  })

  const load = async (file: Uint8Array<ArrayBuffer>, auto: object = AUTO): Promise<GLTF> => {
    const Plugin = name === 'webgl' ? WebGLPlugin : WebGPUPlugin
    const loader = new GLTFLoader().register((parser) => new Plugin(parser, { auto }))
    return loader.parseAsync(file.buffer, '')
  }
  const picture = ({ scene: root }: GLTF) => {
    const scene = new Scene().add(root, new DirectionalLight('white', 3).translateX(1).translateZ(0.5))
    const camera = new OrthographicCamera(-HALF, HALF, HALF, -HALF, 0, 10).translateZ(5)
    return harness.render(scene, camera as OrthographicCamera, SIZE)
  }

  /** Draws until automatic wrinkles have faded in. A frame advances the fade by at most 50 ms. */
  const appear = async (wrinkles: WrinklesBase, gltf: GLTF) => {
    let now = 0
    wrinkles.clock = { now: () => (now += 50) }
    for (let frame = 0; frame < 8; frame++) await picture(gltf)
  }

  it('gets wrinkles after loading, and they fade in', async () => {
    const gltf = await load(await bareSheet())
    expect(wrinklesOf(gltf)).toEqual([])
    const mesh = firstMesh(gltf.scene)
    mesh.morphTargetInfluences![0] = 1
    const plain = await picture(gltf)
    const [wrinkles] = await wrinklesReady(gltf)
    expect(wrinklesOf(gltf)).toEqual([wrinkles])
    expect(wrinklesOf(mesh)).toBe(wrinkles)
    let now = 0
    wrinkles!.clock = { now: () => now }
    expect(largestDifference(await picture(gltf), plain)).toBeLessThan(ROUNDING)
    const differences: number[] = []
    for (let frame = 0; frame < 8; frame++) {
      now += 50
      differences.push(difference(plain, await picture(gltf)))
    }
    // The fade takes 0.3 s, which is six frames of 50 ms.
    for (const frame of [1, 2, 3, 4, 5]) expect(differences[frame]).toBeGreaterThan(differences[frame - 1]!)
    expect(differences[6]).toBe(differences[5])
    expect(differences[7]).toBe(differences[5])
  })

  it('gets heights too, which relief draws', async () => {
    const gltf = await load(await bareSheet())
    const [wrinkles] = await wrinklesReady(gltf)
    wrinkles!.relief = 'on'
    await wrinkles!.reliefReady()
    expect(firstMesh(gltf.scene).children.map((child) => 'isReliefMesh' in child)).toEqual([true])
  })

  it('loads identical wrinkles from the cache, by content and options', async () => {
    const steps = vi.fn()
    const first = await load(await bareSheet(), { ...AUTO, seed: 7, progress: steps })
    const [made] = await wrinklesReady(first)
    expect(steps).toHaveBeenCalled()
    // The loader stores the wrinkles after it has shown them.
    await vi.waitFor(async () => expect(await keptCount()).toBeGreaterThan(0))
    const again = vi.fn()
    const second = await load(await bareSheet(), { ...AUTO, seed: 7, progress: again })
    const [found] = await wrinklesReady(second)
    expect(again).not.toHaveBeenCalled()
    expect(found!.areaNames).toEqual(made!.areaNames)
    expect(found!.getArea(found!.areaNames[0]!)).toEqual(made!.getArea(made!.areaNames[0]!))
    for (const { scene } of [first, second]) firstMesh(scene).morphTargetInfluences![0] = 1
    await appear(made!, first)
    await appear(found!, second)
    // Software rasterisers split a picture between threads, which changes rounding.
    expect(largestDifference(await picture(second), await picture(first))).toBeLessThan(1e-5)
    const other = vi.fn()
    await wrinklesReady(await load(await bareSheet(), { ...AUTO, seed: 8, progress: other }))
    expect(other).toHaveBeenCalled()
  })

  // These tests draw nothing, so one renderer suffices.
  if (name === 'webgl') {
    it.each([
      ['quantised', quantise],
      ['in two primitives', splitInTwo],
      ['without an index', withoutIndex],
      ['placed by a node', scaleNode],
    ])('gets the same wrinkles %s', async (_, edit) => {
      const areas = async (file: Uint8Array<ArrayBuffer>) => {
        const [wrinkles] = await wrinklesReady(await load(file))
        return wrinkles!.getArea(wrinkles!.areaNames[0]!)!.weights as { data: Uint8Array }
      }
      const [{ data: own }, { data: others }] = [
        await areas(await bareSheet()),
        await areas(await bareSheet(edit)),
      ]
      expect(Math.max(...own)).toBe(255)
      expect(difference(own, others) / difference(own, new Uint8Array(own.length))).toBeLessThan(0.05)
    })

    it('reads blendshape names from a primitive', async () => {
      const gltf = await load(await bareSheet(moveNames))
      const [wrinkles] = await wrinklesReady(gltf)
      const mesh = firstMesh(gltf.scene)
      expect(mesh.morphTargetDictionary).toEqual({ squash: 0 })
      mesh.morphTargetInfluences![0] = 1
      wrinkles!.update()
      expect(wrinkles!.getActivation(wrinkles!.areaNames[0]!)).toBeGreaterThan(0.5)
      expect(wrinkles!.drivers).toContainEqual(
        expect.objectContaining({ type: 'morph', targets: [expect.objectContaining({ name: 'squash' })] }),
      )
    })

    it.each<[string, (document: Document) => void, RegExp]>([
      [
        'an unlit material',
        makeUnlit,
        /does not support normal maps.*\(the file is shown without wrinkles\)$/,
      ],
      [
        'no blendshapes',
        withoutTargets,
        /no mesh has blendshapes, and joints .* without the option auto \(the file is shown without wrinkles\)$/,
      ],
      [
        'a blendshape that does nothing',
        stillTarget,
        /no blendshape moves the mesh.*\(the file is shown without wrinkles\)$/,
      ],
    ])('stays plain with %s, with one warning', async (_, edit, message) => {
      const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
      const gltf = await load(await bareSheet(edit))
      expect(await wrinklesReady(gltf)).toEqual([])
      expect(warn.mock.calls).toEqual([[expect.stringMatching(message)]])
    })

    it('gets no wrinkles and no warning if the page has disposed of it or cancelled', async () => {
      const warn = vi.spyOn(console, 'warn')
      const disposed = await load(await bareSheet(), { ...AUTO, seed: 21 })
      firstMesh(disposed.scene).geometry.dispose()
      expect(await wrinklesReady(disposed)).toEqual([])
      const controller = new AbortController()
      const cancelled = await load(await bareSheet(), {
        ...AUTO,
        seed: 22,
        signal: controller.signal,
        progress: () => controller.abort(),
      })
      expect(await wrinklesReady(cancelled)).toEqual([])
      expect(warn).not.toHaveBeenCalled()
      // Another face still gets wrinkles.
      expect(await wrinklesReady(await load(await bareSheet()))).toHaveLength(1)
    })
  }

  it('wrinkles on every node that shows it', async () => {
    const gltf = await load(await bareSheet(showTwice))
    const wrinkles = await wrinklesReady(gltf)
    expect(wrinkles).toHaveLength(2)
    expect(new Set(wrinkles.map(({ mesh }) => mesh.material)).size).toBe(2)
  })
})

function firstMesh(scene: Object3D): Mesh {
  return scene.getObjectByProperty('isMesh', true) as Mesh
}

async function ourCaches(): Promise<string[]> {
  return (await caches.keys()).filter((name) => name.startsWith('furrow-auto-'))
}

/** Counts the automatic wrinkles in the browser's cache. */
async function keptCount(): Promise<number> {
  const lists = await Promise.all((await ourCaches()).map(async (name) => (await caches.open(name)).keys()))
  return lists.flat().length
}

async function forgetAll(): Promise<void> {
  await Promise.all((await ourCaches()).map((name) => caches.delete(name)))
}

function difference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0
  for (let i = 0; i < a.length; i++) sum += Math.abs(a[i]! - b[i]!)
  return sum
}
