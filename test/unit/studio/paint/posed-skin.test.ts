import { expose } from 'comlink'
import { type MetricMesh, type Skin, skinCanvas } from 'furrow/author'
import { canvasArrays } from 'furrow/internal'
import { PoseWatch } from 'furrow/internal/three'
import { Bone, Group, type Mesh, Skeleton, SkinnedMesh } from 'three'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { LineSkin, readLineSkin } from '../../../../studio/src/lines/line-skin.ts'
import { makeSkin } from '../../../../studio/src/paint/make-skin.ts'
import { posedSkinOf, preparedSkin, prepareSkin } from '../../../../studio/src/paint/posed-skin.ts'
import { plainSheet, rayAt } from './skins.ts'

const SCALE = 1000

function lineSkinOf(meshes: [Mesh]): LineSkin {
  const posed = posedSkinOf(meshes, SCALE)
  return new LineSkin(posed, skinCanvas(posed.skin.skin, 64, 64, SCALE), () => undefined)
}

it('painting and lines share one skin of an avatar', () => {
  const meshes: [Mesh] = [plainSheet()]
  const { skin, picker } = posedSkinOf(meshes, SCALE)
  expect(lineSkinOf(meshes).picker).toBe(picker)
  expect(posedSkinOf(meshes, SCALE).skin).toBe(skin)
  expect(posedSkinOf([...meshes], SCALE).skin).not.toBe(skin)
})

it('a face at another scale is another skin', () => {
  const meshes: [Mesh] = [plainSheet()]
  const [metres, half] = [SCALE, SCALE / 2].map((scale) => posedSkinOf(meshes, scale).skin.surface.points[0])
  expect(half).toBeCloseTo(metres / 2, 6)
})

it('a skin that was read earlier gets the current pose', () => {
  const mesh = plainSheet()
  const meshes: [Mesh] = [mesh]
  posedSkinOf(meshes, SCALE)
  mesh.position.y = 0.2
  const { picker } = posedSkinOf(meshes, SCALE)
  const hit = picker.pick(rayAt(0.01, 0.22))
  expect(hit?.position[1]).toBeCloseTo(20, 4)
})

it('the pose of a still face is not read again, and neither is an equal pose', () => {
  const mesh = plainSheet()
  mesh.morphTargetInfluences = [0, 0]
  const meshes: [Mesh] = [mesh]
  const posed = posedSkinOf(meshes, SCALE)
  const refit = vi.spyOn(posed.picker, 'refit').mockReturnValue()
  const lines = lineSkinOf(meshes)
  posedSkinOf(meshes, SCALE)
  lines.follow()
  expect(refit).not.toHaveBeenCalled()
  mesh.morphTargetInfluences[1] = 0.5
  lines.follow()
  posedSkinOf(meshes, SCALE)
  expect(refit).toHaveBeenCalledTimes(1)
})

it('the pose changes with joints, parent nodes, added blendshapes and changed muscles', () => {
  const plain = plainSheet()
  const mesh = new SkinnedMesh(plain.geometry, plain.material)
  const bone = new Bone()
  const parent = new Group()
  parent.add(bone.add(mesh))
  mesh.bind(new Skeleton([bone]))
  const watch = new PoseWatch([mesh])
  const offsets = mesh.geometry.attributes.position.clone()
  const changes: (() => void)[] = [
    () => bone.rotateX(0.1),
    () => parent.position.set(0, 0, 1),
    () => {
      mesh.morphTargetInfluences = [0.3]
    },
    () => {
      mesh.geometry.morphAttributes.position = [offsets]
    },
    () => {
      offsets.needsUpdate = true
    },
  ]
  expect(watch.hasChanged()).toBe(true)
  for (const change of changes) {
    expect(watch.hasChanged()).toBe(false)
    change()
    expect(watch.hasChanged()).toBe(true)
  }
})

describe('a skin made in a worker', () => {
  const AREA = 64
  /** Number of skins that workers were asked to make. */
  let asked = 0

  /** Fake worker in the same thread. Its messages are copied or transferred, like those of a real one. */
  function FakeWorker() {
    const { port1, port2 } = new MessageChannel()
    const service = {
      makeSkin(skin: Skin, scale: number, size: number) {
        asked++
        return { skin, made: makeSkin(skin, scale, size) }
      },
      makeCanvas(mesh: MetricMesh, size: number, scale: number) {
        return canvasArrays(skinCanvas(mesh, size, size, scale))
      },
    }
    expose(service, port2)
    return Object.assign(port1, { terminate: () => port1.close() })
  }

  beforeEach(() => {
    asked = 0
    vi.stubGlobal('Worker', FakeWorker)
  })
  afterEach(() => vi.unstubAllGlobals())

  it('is shared by all tools, and equals one made on the page', async () => {
    const mesh = plainSheet()
    const meshes: [Mesh] = [mesh]
    await prepareSkin(meshes, SCALE, AREA)
    const own = posedSkinOf([mesh], SCALE)
    const prepared = posedSkinOf(meshes, SCALE)
    expect(prepared.skin.surface).toEqual(own.skin.surface)
    // The map for the size of the areas came with the skin, so the page makes none.
    const map = prepared.skin.mapOf(AREA)
    expect(prepared.skin.mapOf(AREA)).toBe(map)
    const { locator, ...arrays } = map
    const { locator: other, ...others } = own.skin.mapOf(AREA)
    expect(arrays).toEqual(others)
    expect(locator.grid).toEqual(other.grid)
    const ray = rayAt(0.011, 0.013)
    expect(prepared.picker.pick(ray)).toEqual(own.picker.pick(ray))
    await prepareSkin(meshes, SCALE, AREA)
    expect(asked).toBe(1)
  })

  it('has the pose of the face when it is ready, and each later pose', async () => {
    const mesh = plainSheet()
    const meshes: [Mesh] = [mesh]
    const preparation = prepareSkin(meshes, SCALE, AREA)
    mesh.position.y = 0.1
    await preparation
    const down = (y: number) => rayAt(0.01, y + 0.02)
    expect(posedSkinOf(meshes, SCALE).picker.pick(down(0.1))?.position[1]).toBeCloseTo(20, 4)
    mesh.position.y = 0.2
    expect(posedSkinOf(meshes, SCALE).picker.pick(down(0.2))?.position[1]).toBeCloseTo(20, 4)
  })

  it('does not replace a skin that the page had to make before, but provides the map of the areas', async () => {
    const meshes: [Mesh] = [plainSheet()]
    const preparation = prepareSkin(meshes, SCALE, AREA)
    const needed = posedSkinOf(meshes, SCALE)
    expect(needed.skin.hasMap(AREA)).toBe(false)
    await preparation
    expect(posedSkinOf(meshes, SCALE)).toBe(needed)
    expect(needed.skin.hasMap(AREA)).toBe(true)
    const map = needed.skin.mapOf(2 * AREA)
    await prepareSkin(meshes, SCALE, 2 * AREA)
    expect(needed.skin.mapOf(2 * AREA)).toBe(map)
    expect(asked).toBe(1)
  })

  it('is made once, however often it is requested, and available to tools when it is ready', async () => {
    const meshes: [Mesh] = [plainSheet()]
    const preparations = [prepareSkin(meshes, SCALE, AREA), prepareSkin(meshes, SCALE, AREA)]
    expect(preparedSkin(meshes, SCALE, AREA)).toBeNull()
    const [first, second] = await Promise.all(preparations)
    expect(second).toBe(first)
    expect(preparedSkin(meshes, SCALE, AREA)).toBe(first)
    expect(preparedSkin(meshes, SCALE, 2 * AREA)).toBeNull()
    expect(asked).toBe(1)
  })

  it('gives lines the same canvas as one made on the page', async () => {
    const meshes: [Mesh] = [plainSheet()]
    const { canvas } = await readLineSkin(meshes, SCALE, AREA)
    const { skin } = posedSkinOf(meshes, SCALE).skin
    const own = skinCanvas(skin, AREA, AREA, SCALE)
    expect(canvasArrays(canvas)).toEqual(canvasArrays(own))
    const weights = [new Float64Array(3), new Float64Array(3)]
    const found = [canvas, own].map(({ locator }, i) => locator.find(0.3, 0.4, weights[i]))
    expect(found[0]).toBe(found[1])
    expect(weights[0]).toEqual(weights[1])
  })

  it('is made on the page if the worker fails, with a message that says why', async () => {
    const meshes: [Mesh] = [plainSheet()]
    await expect(prepareSkin(meshes, SCALE, 1.5)).rejects.toThrow('width of a painted area')
    expect(posedSkinOf(meshes, SCALE).skin.surface.corners.length).toBeGreaterThan(0)
  })
})
