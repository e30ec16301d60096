import type { WrinkleSet } from 'furrow'
import {
  BatchedMesh,
  Bone,
  DirectionalLight,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type OrthographicCamera,
  PlaneGeometry,
  Raycaster,
  type Scene,
  Skeleton,
  SkinnedMesh,
  Sphere,
  SphereGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three'
import { clone as cloneSkinned } from 'three/addons/utils/SkeletonUtils.js'
import { beforeEach, describe, expect, it, vi } from 'vitest'
import { harnessOn, RENDERERS } from '../harness.ts'
import { AMPLITUDE, ball, heightSet, RADIUS, sceneOf, sideCamera } from './ball.ts'
import { differing, FEW } from './differing.ts'
import { displacedMesh } from './displaced-ball.ts'

const SIZE = 256
const SIDE = 0.15

describe.each(RENDERERS)('relief on %s', (name) => {
  const harness = harnessOn(name)
  beforeEach(() => {
    vi.restoreAllMocks()
  })

  const picture = (scene: Scene, camera: OrthographicCamera = sideCamera(SIDE)) =>
    harness.renderBytes(scene, camera, SIZE)

  /** Adds wrinkles, and waits until their relief is ready. */
  async function raised(mesh: Mesh, set = heightSet(), options = {}) {
    const wrinkles = new harness.Wrinkles(mesh, set, { relief: 'on', ...options })
    await wrinkles.reliefReady()
    return wrinkles
  }

  it('leaves the mesh as it was when switched off or disposed of', async () => {
    const mesh = ball()
    const scene = sceneOf(mesh)
    const plain = await picture(scene)
    const hooks = [mesh.onAfterRender, mesh.onBeforeShadow, mesh.onAfterShadow]
    const wrinkles = await raised(mesh)
    const shown = await picture(scene)
    expect(differing(shown, plain)).toBeGreaterThan(100)
    wrinkles.relief = 'off'
    expect(differing(await picture(scene), plain)).toBe(0)
    wrinkles.relief = 'on'
    expect(differing(await picture(scene), shown)).toBe(0)
    wrinkles.mode = 'off'
    expect(differing(await picture(scene), plain)).toBe(0)
    wrinkles.mode = 'default'
    expect(differing(await picture(scene), shown)).toBe(0)
    wrinkles.dispose()
    expect(mesh.children).toEqual([])
    expect([mesh.onAfterRender, mesh.onBeforeShadow, mesh.onAfterShadow]).toEqual(hooks)
    expect(mesh.geometry.drawRange).toEqual({ start: 0, count: Infinity })
    expect(differing(await picture(scene), plain)).toBe(0)
  })

  it('returns in the first frame that shows wrinkles again, however long they were off', async () => {
    const mesh = ball()
    const scene = sceneOf(mesh)
    const wrinkles = await raised(mesh)
    const shown = await picture(scene)
    wrinkles.mode = 'off'
    for (let i = 0; i < 60; i++) harness.renderer.render(scene, sideCamera(SIDE))
    await Promise.resolve()
    expect(mesh.children).toEqual([])
    wrinkles.mode = 'default'
    expect(differing(await picture(scene), shown)).toBe(0)
    wrinkles.dispose()
  })

  it('follows blendshapes and activations in the same frame', async () => {
    const mesh = ball()
    const wrinkles = await raised(mesh)
    const scene = sceneOf(mesh)
    await picture(scene)
    mesh.morphTargetInfluences![0] = 0.7
    expect(differing(await picture(scene), await picture(sceneOf(displacedMesh(mesh))))).toBeLessThan(FEW)
    wrinkles.setActivation('all', 0)
    expect(differing(await picture(scene), await picture(sceneOf(displacedMesh(mesh))))).toBeGreaterThan(100)
    wrinkles.dispose()
  })

  it('casts shadows with its outline', async () => {
    const shadowOf = async (mesh: Mesh) => {
      const scene = sceneOf(mesh)
      const ground = new Mesh(new PlaneGeometry(1, 1), new MeshStandardMaterial())
      ground.position.z = -0.1
      ground.receiveShadow = mesh.castShadow = true
      const light = new DirectionalLight(0xffffff, 3)
      light.position.set(0.1, 0.02, 0.1)
      light.castShadow = true
      light.shadow.mapSize.set(2048, 2048)
      Object.assign(light.shadow.camera, {
        left: -0.1,
        right: 0.1,
        top: 0.1,
        bottom: -0.1,
        near: 0.01,
        far: 0.5,
      })
      scene.add(ground, light)
      await picture(scene, sideCamera(0.4))
      return picture(scene, sideCamera(0.4))
    }
    const { shadowMap } = harness.renderer
    shadowMap.enabled = true
    const mesh = ball()
    const plain = await shadowOf(mesh)
    const wrinkles = await raised(mesh)
    const shown = await shadowOf(mesh)
    const expected = await shadowOf(displacedMesh(mesh))
    expect(differing(plain, expected)).toBeGreaterThan(5 * differing(shown, expected))
    wrinkles.dispose()
    shadowMap.enabled = false
  })

  it('is separate for each instance', async () => {
    const { geometry, material } = ball()
    geometry.morphAttributes = {}
    const mesh = new InstancedMesh(geometry, material, 2)
    mesh.setMatrixAt(0, new Matrix4().makeTranslation(-0.06, 0, 0))
    mesh.setMatrixAt(1, new Matrix4().makeTranslation(0.06, 0, 0))
    const wrinkles = new harness.Wrinkles(mesh, heightSet(), { relief: 'on' })
    wrinkles.setActivation('all', 0, 0)
    await wrinkles.reliefReady()
    const scene = sceneOf(mesh)
    const camera = sideCamera(0.24)
    await picture(scene, camera)
    const shown = await picture(scene, camera)
    const [flat, raised] = [ball(), displacedMesh(ball())]
    flat.position.x = -0.06
    raised.position.x = 0.06
    const expected = await picture(sceneOf(flat, raised), camera)
    const left = (pixels: Uint8Array) => pixels.filter((_, i) => Math.floor(i / 4) % SIZE < SIZE / 2)
    const right = (pixels: Uint8Array) => pixels.filter((_, i) => Math.floor(i / 4) % SIZE >= SIZE / 2)
    expect(differing(right(shown), right(expected))).toBeLessThan(FEW)
    expect(differing(left(shown), left(expected))).toBeLessThan(200)
    wrinkles.dispose()
  })

  it('follows a skeleton, and is separate for a copy', async () => {
    const { mesh, bone } = skinnedBall()
    const wrinkles = await raised(mesh)
    const scene = sceneOf(mesh)
    bone.rotation.z = 0.5
    bone.position.x = 0.01
    const shown = await picture(scene)
    const expected = displacedMesh(ball())
    expected.rotation.z = 0.5
    expected.position.x = 0.01
    expect(differing(shown, await picture(sceneOf(expected)))).toBeLessThan(FEW)
    const copy = cloneSkinned(scene)
    copy.traverse((object) => expect('isReliefMesh' in object).toBe(false))
    wrinkles.dispose()
  })

  it("keeps the mesh's shading normals, so that heights do not count twice", async () => {
    const lit = (mesh: Mesh) => {
      const light = new DirectionalLight(0xffffff, 3)
      light.position.set(1, 1, 1)
      return sceneOf(mesh).add(light)
    }
    const mesh = ball(48)
    mesh.material = new MeshStandardMaterial()
    const wrinkles = new harness.Wrinkles(mesh, heightSet())
    const scene = lit(mesh)
    const plain = await picture(scene)
    wrinkles.relief = 'on'
    await wrinkles.reliefReady()
    const shown = await picture(scene)
    let worst = 0
    for (let y = 96; y < 160; y++) {
      for (let i = 4 * (96 + y * SIZE); i < 4 * (160 + y * SIZE); i++)
        worst = Math.max(worst, Math.abs(shown[i] - plain[i]))
    }
    expect(worst).toBeLessThan(14)
    wrinkles.dispose()
  })

  it('is not hit by rays, which hit the mesh once', async () => {
    const mesh = ball()
    const wrinkles = await raised(mesh)
    const hits = new Raycaster(new Vector3(0, 0, 1), new Vector3(0, 0, -1)).intersectObject(
      sceneOf(mesh),
      true,
    )
    expect(hits.every(({ object }) => object === mesh)).toBe(true)
    expect(hits.length).toBeGreaterThan(0)
    wrinkles.dispose()
  })

  it('is drawn once in a pass with another material', async () => {
    const mesh = ball()
    const wrinkles = await raised(mesh)
    const scene = sceneOf(mesh)
    await picture(scene)
    scene.overrideMaterial = new MeshBasicMaterial({ color: 0x00ff00 })
    const pixels = await picture(scene)
    const middle = 4 * (SIZE / 2 + (SIZE / 2) * SIZE)
    expect([...pixels.subarray(middle, middle + 3)]).toEqual([0, 255, 0])
    mesh.visible = false
    expect((await picture(scene)).every((value, i) => i % 4 === 3 || value === 0)).toBe(true)
    wrinkles.dispose()
  })

  it('works in composed mode', async () => {
    const mesh = ball()
    const scene = sceneOf(mesh)
    const wrinkles = await raised(mesh, heightSet(), { mode: 'composed' })
    await picture(scene)
    const shown = await picture(scene)
    expect(differing(shown, await picture(sceneOf(displacedMesh(mesh))))).toBeLessThan(FEW)
    wrinkles.dispose()
  })

  it('has fewer triangles when it is smaller in the picture', async () => {
    const mesh = ball(48)
    const wrinkles = await raised(mesh)
    const scene = sceneOf(mesh)
    const [{ geometry }] = mesh.children as Mesh[]
    const drawn = []
    for (const side of [0.02, 0.05, SIDE]) {
      await picture(scene, sideCamera(side))
      drawn.push(geometry.drawRange.count)
    }
    expect(drawn).toEqual(geometry.groups.map(({ count }) => count))
    expect(drawn).toEqual([...new Set(drawn)].sort((a, b) => b - a))
    wrinkles.dispose()
  })

  it('is drawn in mode near only if it can be seen', async () => {
    const mesh = ball()
    const wrinkles = new harness.Wrinkles(mesh, heightSet(), { relief: 'near' })
    const scene = sceneOf(mesh)
    const far = sideCamera(0.5)
    await picture(scene, far)
    expect(mesh.children).toEqual([])
    await picture(scene)
    await wrinkles.reliefReady()
    await picture(scene)
    expect(mesh.children).toHaveLength(1)
    expect(differing(await picture(scene), await picture(sceneOf(displacedMesh(mesh))))).toBeLessThan(FEW)
    for (let i = 0; i < 60; i++) await picture(scene, far)
    expect(mesh.children).toEqual([])
    wrinkles.dispose()
  })

  it('is not drawn for a face at rest, at any size', async () => {
    const mesh = ball()
    const plain = await picture(sceneOf(ball()))
    const wrinkles = new harness.Wrinkles(mesh, heightSet())
    const [area] = wrinkles.areaNames
    const scene = sceneOf(mesh)
    await wrinkles.reliefReady()
    await picture(scene)
    await picture(scene)
    expect(mesh.children).toHaveLength(1)
    wrinkles.setActivation(area, 0)
    for (let i = 0; i < 60; i++) await picture(scene)
    expect(mesh.children).toEqual([])
    expect(await picture(scene)).toEqual(plain)
    wrinkles.setActivation(area, 0.05)
    await picture(scene)
    await picture(scene)
    expect(mesh.children).toHaveLength(1)
    wrinkles.dispose()
  })

  it('splits the mesh again after it gets another geometry', async () => {
    const mesh = ball()
    const wrinkles = await raised(mesh)
    const scene = sceneOf(mesh)
    await picture(scene)
    const larger = ball().geometry.scale(1.2, 1.2, 1.2)
    mesh.geometry = larger
    await picture(scene)
    await wrinkles.reliefReady()
    await picture(scene)
    const expected = await picture(sceneOf(displacedMesh(Object.assign(ball(), { geometry: larger }))))
    expect(differing(await picture(scene), expected)).toBeLessThan(FEW)
    wrinkles.dispose()
  })

  it('draws no degenerate triangles below an area', async () => {
    const [mesh, other] = [ball(), ball()]
    const indices = [...other.geometry.index!.array]
    other.geometry.setIndex([...indices, 40, 40, 40, 60, 61, 61, indices[90], indices[91], indices[90]])
    const wrinkles = await raised(mesh)
    const pictures = [await picture(sceneOf(mesh))]
    wrinkles.dispose()
    const others = await raised(other)
    pictures.push(await picture(sceneOf(other)))
    expect(other.children).toHaveLength(1)
    expect(pictures[1]).toEqual(pictures[0])
    others.dispose()
  })

  it('moves the complete surface if the height map is a single texel', async () => {
    const { layers, areas } = heightSet()
    const height = { width: 1, height: 1, data: new Uint8Array([255]) }
    const mesh = ball(64)
    const wrinkles = await raised(mesh, { layers: [{ ...layers[0], height }], areas })
    const shown = await picture(sceneOf(mesh))
    const larger = ball(64)
    larger.scale.setScalar(1 + AMPLITUDE / 2 / RADIUS)
    expect(differing(shown, await picture(sceneOf(larger)))).toBeLessThan(FEW)
    expect(differing(shown, await picture(sceneOf(ball(64))))).toBeGreaterThan(10 * FEW)
    wrinkles.dispose()
  })

  it('accepts layers whose heights are large only together', async () => {
    const { layers, areas } = heightSet()
    const [layer] = layers
    const high = ['', ' 2', ' 3'].map((end) => {
      return { ...layer, name: `${layer.name}${end}`, heightAmplitude: 0.08 * RADIUS }
    })
    const mesh = ball()
    const wrinkles = await raised(mesh, { layers: high, areas })
    await picture(sceneOf(mesh))
    expect(mesh.children).toHaveLength(1)
    wrinkles.dispose()
  })

  it.each([
    ['heights of 10 m', () => ball(), 10, 'displace the surface too far'],
    ['positions that are not numbers', () => brokenBall(), 0.003, 'positions that are not numbers'],
  ])('is left out with one warning, in modes on and near: %s', async (_, make, heightAmplitude, message) => {
    for (const relief of ['on', 'near'] as const) {
      const { layers, areas } = heightSet()
      const { warnings } = await drawn(make(), { layers: [{ ...layers[0], heightAmplitude }], areas }, relief)
      expect(warnings).toEqual([expect.stringContaining(message)])
      expect(warnings[0]).toContain('(the wrinkles are shown without relief)')
    }
  })

  it.each([
    [
      'a mesh of 110,000 triangles',
      () => new Mesh(new SphereGeometry(RADIUS, 235, 235), new MeshStandardMaterial()),
      'too many triangles',
    ],
    ['batches', () => batch(), 'BatchedMesh'],
    [
      'instances with their own blendshape weights',
      () => crowd(),
      'instances with their own blendshape weights',
    ],
  ])('is missing for %s: with one warning in mode on, silently in mode near', async (_, make, message) => {
    const { layers, areas } = heightSet()
    const readHeight = vi.fn()
    const unread = { ...layers[0], height: undefined, readHeight }
    const { wrinkles, warnings, scene } = await drawn(make(), { layers: [unread], areas }, 'near')
    expect(warnings).toEqual([])
    expect(readHeight).not.toHaveBeenCalled()
    wrinkles.relief = 'on'
    await picture(scene)
    expect(warnings).toEqual([expect.stringContaining(message)])
    expect((await drawn(make(), heightSet(), 'on')).warnings).toEqual([expect.stringContaining(message)])
  })

  it('has longer edges if there are too many triangles: with one warning in mode on, silently in mode near', async () => {
    const large = ball()
    large.geometry.scale(20, 20, 20)
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const wrinkles = await raised(large, heightSet(), { relief: 'near' })
    expect(warn).not.toHaveBeenCalled()
    wrinkles.relief = 'on'
    expect(warn.mock.calls).toEqual([[expect.stringContaining('so the edges of its triangles are longer')]])
    expect(large.children).toHaveLength(1)
    wrinkles.dispose()
  })

  /** Draws a mesh that cannot have relief several times, and returns the warnings. */
  async function drawn(mesh: Mesh, set: WrinkleSet, relief: 'on' | 'near') {
    const warnings: string[] = []
    vi.spyOn(console, 'warn').mockImplementation((text) => {
      // Ignores a warning of three.js in browsers, such as Firefox, that lack an extension for batches.
      if (!text.includes('WEBGL_multi_draw extension not supported')) warnings.push(text)
    })
    const wrinkles = await raised(mesh, set, { relief })
    const scene = sceneOf(mesh)
    await picture(scene)
    await picture(scene)
    expect(mesh.children).toEqual([])
    return { wrinkles, warnings, scene }
  }
})

/** Creates a ball with an unused vertex at NaN. Sets its bounds, because three.js would warn when computing them. */
function brokenBall() {
  const mesh = ball()
  const { geometry } = mesh
  geometry.attributes.position.setX(0, Number.NaN)
  geometry.boundingSphere = new Sphere(new Vector3(), Number.NaN)
  return mesh
}

/** Creates a ball that is skinned to one bone. */
function skinnedBall() {
  const { geometry, material } = ball()
  geometry.morphAttributes = {}
  const { count } = geometry.attributes.position
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4))
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => Number(i % 4 === 0))
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4))
  const bone = new Bone()
  const mesh = new SkinnedMesh(geometry, material)
  mesh.add(bone)
  mesh.bind(new Skeleton([bone]))
  return { mesh, bone }
}

/** Creates two instances of a ball, one of them taller. */
function crowd(): InstancedMesh {
  const { geometry, material } = ball()
  const mesh = new InstancedMesh(geometry, material, 2)
  const shaped = ball()
  for (const i of [0, 1]) {
    mesh.setMatrixAt(i, new Matrix4())
    shaped.morphTargetInfluences![0] = i
    mesh.setMorphAt(i, shaped)
  }
  return mesh
}

function batch(): BatchedMesh {
  const { geometry, material } = ball()
  geometry.morphAttributes = {}
  const mesh = new BatchedMesh(1, 1000, 4000, material as MeshStandardMaterial)
  mesh.addInstance(mesh.addGeometry(geometry))
  return mesh
}
