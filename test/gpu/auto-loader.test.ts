import { WrinkleLoaderPlugin as WebGLPlugin, wrinklesOf, wrinklesReady } from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin } from 'furrow/webgpu'
import { DirectionalLight, type Mesh, OrthographicCamera, Scene } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest'
import { bareSheet, HALF } from './bare-sheet.ts'
import { createHarness, type Harness, RENDERERS } from './harness.ts'

const SIZE = 64
const AUTO = { size: 256, areaSize: 32 }

describe.each(RENDERERS)('a file without wrinkles on %s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())
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

  it('gets them after it was loaded, and they fade in', async () => {
    const gltf = await load(await bareSheet())
    expect(wrinklesOf(gltf)).toEqual([])
    const mesh = meshOf(gltf)
    mesh.morphTargetInfluences![0] = 1
    const plain = await picture(gltf)
    const [wrinkles] = await wrinklesReady(gltf)
    expect(wrinklesOf(gltf)).toEqual([wrinkles])
    expect(wrinklesOf(mesh)).toBe(wrinkles)
    let now = 0
    wrinkles!.clock = { now: () => now }
    wrinkles!.appear(0.3)
    expect(await picture(gltf)).toEqual(plain)
    const differences: number[] = []
    for (let frame = 0; frame < 8; frame++) {
      now += 50
      differences.push(difference(plain, await picture(gltf)))
    }
    // Six frames of 50 ms are 0.3 s.
    for (const frame of [1, 2, 3, 4, 5]) expect(differences[frame]).toBeGreaterThan(differences[frame - 1]!)
    expect(differences[6]).toBe(differences[5])
    expect(differences[7]).toBe(differences[5])
  })
})

function meshOf(gltf: GLTF): Mesh {
  let found: Mesh | undefined
  gltf.scene.traverse((object) => {
    if ((object as Mesh).isMesh) found ??= object as Mesh
  })
  return found!
}

function difference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0
  for (let i = 0; i < a.length; i++) sum += Math.abs(a[i]! - b[i]!)
  return sum
}
