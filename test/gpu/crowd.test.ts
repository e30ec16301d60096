import type { WrinkleSet } from 'furrow'
import { removeArea } from 'furrow/three'
import {
  BatchedMesh,
  BufferAttribute,
  DirectionalLight,
  InstancedMesh,
  Matrix4,
  type Mesh,
  MeshStandardMaterial,
  type OrthographicCamera,
  Scene,
} from 'three'
import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const PIXELS = 32
const HALF = PIXELS / 2

/** Centres of four faces, one per quarter of the picture, row by row from the bottom. */
const CENTRES = [
  [-0.5, -0.5],
  [0.5, -0.5],
  [-0.5, 0.5],
  [0.5, 0.5],
] as const

/** Activations of each face's areas. */
const ACTIVATIONS = [
  [0, 0, 0],
  [1, 0, 0.5],
  [0, 0.75, 0.25],
  [0.5, 1, 1],
] as const

describe.each(RENDERERS)('a crowd on %s', (name) => {
  const harness = harnessOn(name)
  let set: WrinkleSet
  beforeAll(() => {
    set = randomSet(seeded(5), 3, 8)
  })
  afterEach(() => {
    vi.restoreAllMocks()
  })

  const face = ([x, y]: readonly [number, number]): Mesh => {
    const mesh = square(new MeshStandardMaterial({ roughness: 0.5 }))
    mesh.position.set(x, y, 0)
    mesh.scale.setScalar(0.5)
    return mesh
  }
  const addWrinkles = (mesh: Mesh) => new harness.Wrinkles(mesh, set, { areaSize: 8 })
  const activate = (wrinkles: ReturnType<typeof addWrinkles>, values: readonly number[], instance = 0) => {
    for (const [i, value] of values.entries()) wrinkles.setActivation(`area${i}`, value, instance)
  }
  const sceneOf = (...meshes: Mesh[]) => {
    const scene = new Scene()
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1.5)
    return scene.add(light, ...meshes)
  }
  const draw = (scene: Scene, camera: OrthographicCamera = squareCamera()) =>
    harness.renderBytes(scene, camera, PIXELS)
  /** Renders each face alone, and returns its quarter of the picture. */
  const alone = () =>
    Promise.all(
      CENTRES.map(async (centre, i) => {
        const mesh = face(centre)
        const wrinkles = addWrinkles(mesh)
        activate(wrinkles, ACTIVATIONS[i])
        const picture = quarter(await draw(sceneOf(mesh)), i)
        wrinkles.dispose()
        return picture
      }),
    )

  it('wrinkles each face independently, also when faces are added and removed', async () => {
    const expected = await alone()
    expect(new Set(expected.map(String)).size).toBe(4)
    const scene = sceneOf()
    const all = []
    for (const [i, centre] of CENTRES.entries()) {
      const mesh = face(centre)
      scene.add(mesh)
      all.push(addWrinkles(mesh))
      activate(all[i], ACTIVATIONS[i])
      const picture = await draw(scene)
      for (let k = 0; k <= i; k++) expect(quarter(picture, k), `face ${k} of ${i + 1}`).toEqual(expected[k])
    }
    all[1].dispose()
    const picture = await draw(scene)
    for (const k of [0, 2, 3]) expect(quarter(picture, k), `face ${k} without 1`).toEqual(expected[k])
    expect(quarter(picture, 1)).not.toEqual(expected[1])
    for (const k of [0, 2, 3]) all[k].dispose()
  })

  it('wrinkles each instance of a mesh independently', async () => {
    const expected = await alone()
    const instances = new InstancedMesh(
      face([0, 0]).geometry,
      new MeshStandardMaterial({ roughness: 0.5 }),
      4,
    )
    for (const [i, [x, y]] of CENTRES.entries()) {
      instances.setMatrixAt(i, new Matrix4().makeScale(0.5, 0.5, 1).setPosition(x, y, 0))
    }
    const wrinkles = addWrinkles(instances)
    for (const [i, values] of ACTIVATIONS.entries()) activate(wrinkles, values, i)
    const picture = await draw(sceneOf(instances))
    for (const i of CENTRES.keys()) expect(quarter(picture, i), `instance ${i}`).toEqual(expected[i])
    wrinkles.dispose()
  })

  it('draws many influence maps correctly after frames in which only few changed', async () => {
    const side = 8
    const crowdOf = () => {
      const mesh = new InstancedMesh(
        face([0, 0]).geometry,
        new MeshStandardMaterial({ roughness: 0.5 }),
        side ** 2,
      )
      for (let i = 0; i < side ** 2; i++) {
        const [x, y] = [i % side, Math.floor(i / side)].map((at) => (2 * at + 1) / side - 1)
        mesh.setMatrixAt(i, new Matrix4().makeScale(1 / side, 1 / side, 1).setPosition(x, y, 0))
      }
      return { scene: sceneOf(mesh), wrinkles: addWrinkles(mesh) }
    }
    const show = async ({ scene, wrinkles }: ReturnType<typeof crowdOf>, count: number, add = 0) => {
      for (let i = 0; i < count; i++) activate(wrinkles, [(i % 5) / 4, (i % 3) / 2, add + (i % 7) / 14], i)
      return draw(scene)
    }
    const [gradual, flat] = [crowdOf(), crowdOf()]
    const few = await show(gradual, 2)
    const all = await show(gradual, side ** 2)
    await show(gradual, 2, 0.5)
    // Two of the maps are redrawn. The others must not change.
    expect(await show(gradual, 2)).toEqual(all)
    expect(few).not.toEqual(all)
    expect(await show(flat, side ** 2)).toEqual(all)
    for (const { wrinkles } of [gradual, flat]) wrinkles.dispose()
  })

  it('wrinkles each instance of a batch independently, in any drawing order', async () => {
    const expected = await alone()
    const batch = new BatchedMesh(6, 4, 6, new MeshStandardMaterial({ roughness: 0.5 }))
    const quad = batch.addGeometry(face([0, 0]).geometry)
    // Hides two instances, which changes the drawing indices of the visible ones.
    const ids = Array.from({ length: 6 }, () => batch.addInstance(quad))
    batch.setVisibleAt(ids[0], false)
    batch.setVisibleAt(ids[3], false)
    const visible = [ids[5], ids[1], ids[4], ids[2]]
    for (const [i, [x, y]] of CENTRES.entries()) {
      batch.setMatrixAt(visible[i], new Matrix4().makeScale(0.5, 0.5, 1).setPosition(x, y, 0))
    }
    const wrinkles = addWrinkles(batch)
    for (const [i, values] of ACTIVATIONS.entries()) activate(wrinkles, values, visible[i])
    const picture = await draw(sceneOf(batch))
    for (const i of CENTRES.keys()) expect(quarter(picture, i), `instance ${i}`).toEqual(expected[i])
    wrinkles.dispose()
    batch.dispose()
  })

  it('shares the textures of other wrinkles until the last user is disposed', async () => {
    const expected = await alone()
    const meshes = CENTRES.map(face)
    const first = addWrinkles(meshes[0])
    const all = [first, ...meshes.slice(1).map((mesh) => new harness.Wrinkles(mesh, first))]
    for (const [i, wrinkles] of all.entries()) activate(wrinkles, ACTIVATIONS[i])
    const scene = sceneOf(...meshes)
    await draw(scene)
    first.dispose()
    const picture = await draw(scene)
    for (const i of [1, 2, 3]) expect(quarter(picture, i), `face ${i}`).toEqual(expected[i])
    removeArea(all[1], 'area2')
    const withoutArea = await draw(scene)
    expect(quarter(withoutArea, 1)).not.toEqual(expected[1])
    for (const i of [2, 3]) expect(quarter(withoutArea, i), `face ${i}`).toEqual(expected[i])
    for (const wrinkles of all.slice(1)) wrinkles.dispose()
  })

  it('draws the influence of all faces in one pass, and only after a change of more than 1/510', async () => {
    const meshes = CENTRES.map(face)
    const all = meshes.map(addWrinkles)
    const scene = sceneOf(...meshes)
    for (const wrinkles of all) activate(wrinkles, [0.5, 0, 0])
    await draw(scene)
    const render = vi.spyOn(harness.renderer, 'render')
    const passes = async () => {
      render.mockClear()
      await draw(scene)
      return render.mock.calls.length - 1
    }
    expect(await passes(), 'no change').toBe(0)
    for (const wrinkles of all) activate(wrinkles, [0.6, 0.2, 0])
    expect(await passes(), 'all changed').toBe(1)
    all[2].setActivation('area0', 0.6 + 0.9 / 510)
    expect(await passes(), 'too small a change').toBe(0)
    all[2].setActivation('area0', 0.6 + 1.1 / 510)
    expect(await passes(), 'a sufficient change').toBe(1)
    all[2].setActivation('area1', 1e-4)
    expect(await passes(), 'a small activation').toBe(1)
    all[2].setActivation('area1', 0)
    expect(await passes(), 'to 0, however small the change').toBe(1)
    for (const wrinkles of all) wrinkles.dispose()
  })

  it('compiles nothing after the first frame', async () => {
    const meshes = CENTRES.map(face)
    const all = meshes.map(addWrinkles)
    const scene = sceneOf(...meshes)
    for (const wrinkles of all) activate(wrinkles, [0.5, 0.5, 0.5])
    await draw(scene)
    const programs = harness.programs()
    for (const [i, wrinkles] of all.entries()) activate(wrinkles, ACTIVATIONS[i])
    await draw(scene)
    expect(harness.programs()).toBe(programs)
    for (const wrinkles of all) wrinkles.dispose()
  })

  it('fades the wrinkles of faces that are small on screen', async () => {
    const mesh = face([0, 0])
    const scene = sceneOf(mesh)
    const plain = await draw(scene)
    const changeAt = async (fadeBelow: number) => {
      const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 8, fadeBelow })
      activate(wrinkles, [1, 1, 1])
      const picture = await draw(scene)
      wrinkles.dispose()
      return totalDifference(plain, picture)
    }
    // Size on screen is the diameter of the bounding sphere: the diagonal of the square, 22.6 of 32 pixels.
    const [full, half, none] = [await changeAt(20), await changeAt((22.6 * 4) / 3), await changeAt(46)]
    expect(full).toBe(await changeAt(0))
    expect(none).toBe(0)
    expect(half).toBeGreaterThan(0.2 * full)
    expect(half).toBeLessThan(0.8 * full)
  })

  it('draws instances that have blendshapes but no weights, and warns once', async () => {
    const expected = await alone()
    const { geometry } = face([0, 0])
    const target = new BufferAttribute(new Float32Array(12), 3)
    geometry.morphAttributes = { position: [target], normal: [target] }
    geometry.morphTargetsRelative = true
    const instances = new InstancedMesh(geometry, new MeshStandardMaterial({ roughness: 0.5 }), 4)
    for (const [i, [x, y]] of CENTRES.entries()) {
      instances.setMatrixAt(i, new Matrix4().makeScale(0.5, 0.5, 1).setPosition(x, y, 0))
    }
    const wrinkles = addWrinkles(instances)
    for (const [i, values] of ACTIVATIONS.entries()) activate(wrinkles, values, i)
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const scene = sceneOf(instances)
    await draw(scene)
    const picture = await draw(scene)
    for (const i of CENTRES.keys()) expect(quarter(picture, i), `instance ${i}`).toEqual(expected[i])
    expect(warn.mock.calls).toEqual([[expect.stringContaining('has blendshapes and no weights')]])
    wrinkles.dispose()
  })

  it('drives each instance by its own blendshapes', async () => {
    const geometry = square(new MeshStandardMaterial()).geometry
    const target = new BufferAttribute(new Float32Array(12), 3)
    target.name = 'browInnerUp'
    geometry.morphAttributes.position = [target]
    geometry.morphTargetsRelative = true
    const instances = new InstancedMesh(geometry, new MeshStandardMaterial({ roughness: 0.5 }), 2)
    const pose = face([0, 0])
    pose.geometry = geometry
    pose.updateMorphTargets()
    for (const i of [0, 1]) {
      instances.setMatrixAt(
        i,
        new Matrix4().makeScale(0.5, 0.5, 1).setPosition(CENTRES[i][0], CENTRES[i][1], 0),
      )
      pose.morphTargetInfluences![0] = [0.25, 0.75][i]
      instances.setMorphAt(i, pose)
    }
    const wrinkles = addWrinkles(instances)
    const { addDrivers } = await import('furrow/three')
    addDrivers(wrinkles, [
      {
        type: 'morph',
        area: 'area0',
        targets: [{ name: 'browInnerUp', weight: 1 }],
        curve: [
          [0, 0],
          [1, 1],
        ],
      },
    ])
    await draw(sceneOf(instances))
    expect([0, 1].map((i) => wrinkles.getActivation('area0', i))).toEqual([0.25, 0.75])
    wrinkles.dispose()
  })
})

/** Returns the bytes of one quarter of a picture. */
function quarter(picture: Uint8Array, i: number): Uint8Array {
  const rows = Array.from({ length: HALF }, (_, y) => {
    const start = ((y + (i >> 1) * HALF) * PIXELS + (i % 2) * HALF) * 4
    return [...picture.subarray(start, start + HALF * 4)]
  })
  return Uint8Array.from(rows.flat())
}

function totalDifference(a: Uint8Array, b: Uint8Array): number {
  return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0)
}
