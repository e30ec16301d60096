import { RecomputedNormals as CpuNormals } from 'furrow/three'
import { RecomputedNormals } from 'furrow/webgpu'
import {
  Bone,
  type BufferAttribute,
  type BufferGeometry,
  Float32BufferAttribute,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  REVISION,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
} from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest'
import { loadFace } from '../../stage/face.ts'
import { seeded } from '../random.ts'
import { deviceErrors } from './device-errors.ts'
import { largestDifference } from './difference.ts'
import { faceScene, HEIGHT, WIDTH } from './face.ts'
import { createHarness, type Harness } from './harness.ts'

const SMILE = { mouthSmileLeft: 1, jawOpen: 0.7, browDownLeft: 0.8, cheekPuff: 0.5 }

let harness: Harness
let renderer: WebGPURenderer
let errors: string[]

beforeAll(async () => {
  harness = await createHarness('webgpu')
  renderer = harness.renderer as WebGPURenderer
  errors = deviceErrors(harness)
})
afterEach(() => expect(errors).toEqual([]))
afterAll(() => harness.dispose())

/** Creates a ball with two random blendshapes. Vertices at the same position move together. */
function ball(geometry: BufferGeometry = new SphereGeometry(1, 24, 16)): Mesh {
  const { position } = geometry.attributes
  const random = seeded(5)
  const moved = new Map<string, number[]>()
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = [0, 1].map((target) => {
    const offsets = Array.from({ length: position.count }, (_, i) => {
      const key = [target, position.getX(i), position.getY(i), position.getZ(i)].join()
      if (!moved.has(key))
        moved.set(
          key,
          Array.from({ length: 3 }, () => 0.1 * (random() - 0.5)),
        )
      return moved.get(key)!
    })
    return new Float32BufferAttribute(offsets.flat(), 3)
  })
  return new Mesh(geometry)
}

/** Reads an attribute from the CPU or the GPU: x, y and z per vertex. */
async function read(mesh: Mesh, name: 'normal' | 'tangent'): Promise<Float32Array> {
  const attribute = mesh.geometry.attributes[name] as BufferAttribute
  const values =
    'isStorageBufferAttribute' in attribute
      ? new Float32Array(await renderer.getArrayBufferAsync(attribute))
      : attribute.array
  const stride = values.length / attribute.count
  return Float32Array.from(
    { length: 3 * attribute.count },
    (_, i) => values[stride * Math.floor(i / 3) + (i % 3)],
  )
}

/** Returns the angles between the vectors of two lists, degrees, ascending. */
function angles(a: Float32Array, b: Float32Array): Float64Array {
  return Float64Array.from({ length: a.length / 3 }, (_, i) => {
    const [u, v] = [a, b].map((list) => list.subarray(3 * i, 3 * i + 3))
    const sine = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return (Math.atan2(sine, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * 180) / Math.PI
  }).sort()
}

/** Deforms two copies of a mesh, and compares the vectors that the GPU and the CPU compute. */
async function compare(mesh: Mesh, weights: readonly number[], names: readonly ('normal' | 'tangent')[]) {
  const copy = new Mesh(mesh.geometry)
  const [computed, expected] = [new RecomputedNormals(mesh), new CpuNormals(copy)]
  for (const { morphTargetInfluences } of [mesh, copy]) Object.assign(morphTargetInfluences ?? [], weights)
  computed.update(renderer)
  expected.update()
  const found = []
  for (const name of names) found.push(angles(await read(mesh, name), await read(copy, name)))
  computed.dispose()
  expected.dispose()
  return found
}

describe('RecomputedNormals on WebGPU', () => {
  it('computes the same normals and tangents of the shipped face as the CPU', async () => {
    const { skin } = await loadFace('/faces/human.glb')
    const weights = Object.keys(skin.morphTargetDictionary!).map(
      (name) => SMILE[name as keyof typeof SMILE] ?? 0,
    )
    expect(weights.filter((weight) => weight > 0)).toHaveLength(4)
    const rest = await read(skin, 'normal')
    const copy = new Mesh(skin.geometry)
    const expected = new CpuNormals(copy)
    Object.assign(copy.morphTargetInfluences!, weights)
    expected.update()
    const rotations = angles(rest, await read(copy, 'normal'))
    expect(rotations.at(-1), 'the pose rotates normals').toBeGreaterThan(30)
    for (const found of await compare(skin, weights, ['normal', 'tangent'])) {
      expect(found[Math.floor(0.999 * found.length)]).toBeLessThan(0.05)
      expect(found.at(-1)).toBeLessThan(0.5)
    }
  })

  it.each([
    ['with an index and without tangents', () => ball()],
    ['without an index', () => ball(new SphereGeometry(1, 12, 8).toNonIndexed())],
    ['without blendshapes', () => new Mesh(new SphereGeometry())],
    ['with targets that are not relative', () => absolute(ball())],
  ])('computes the same normals for a mesh %s', async (_, make) => {
    const [found] = await compare(make(), [0.8, -0.5], ['normal'])
    expect(found.at(-1)).toBeLessThan(0.01)
  })

  it('ignores the rotation of joints, and restores normals when the weights return to 0', async () => {
    const { geometry } = ball()
    const { count } = geometry.attributes.position
    geometry.setAttribute('skinIndex', new Float32BufferAttribute(new Float32Array(4 * count), 4))
    geometry.setAttribute('skinWeight', new Float32BufferAttribute(new Float32Array(4 * count).fill(0.25), 4))
    const mesh = new SkinnedMesh(geometry)
    const bone = new Bone()
    mesh.add(bone).bind(new Skeleton([bone]))
    bone.rotation.x = 1
    mesh.updateMatrixWorld(true)
    expect((await compare(mesh, [1, 1], ['normal']))[0].at(-1)).toBeLessThan(0.01)
    const rest = await read(mesh, 'normal')
    const normals = new RecomputedNormals(mesh)
    mesh.morphTargetInfluences!.fill(1)
    normals.update(renderer)
    expect(angles(await read(mesh, 'normal'), rest).at(-1)).toBeGreaterThan(5)
    mesh.morphTargetInfluences!.fill(0)
    normals.update(renderer)
    expect(angles(await read(mesh, 'normal'), rest).at(-1)).toBeLessThan(0.01)
    normals.dispose()
  })

  it('updates after positions changed', async () => {
    const mesh = new Mesh(new PlaneGeometry(1, 1, 9, 9))
    const normals = new RecomputedNormals(mesh)
    normals.update(renderer)
    const { position } = mesh.geometry.attributes
    for (let i = 0; i < position.count; i++) position.setZ(i, 0.5 * position.getX(i))
    position.needsUpdate = true
    normals.update(renderer)
    const slope = Math.hypot(1, 0.5)
    const found = await read(mesh, 'normal')
    for (let i = 0; i < position.count; i++) {
      expect(found[3 * i]).toBeCloseTo(-0.5 / slope, 5)
      expect(found[3 * i + 2]).toBeCloseTo(1 / slope, 5)
    }
    normals.dispose()
  })

  it('does not compute again while the weights are unchanged', () => {
    const mesh = ball()
    const normals = new RecomputedNormals(mesh)
    const { compute } = renderer.info as unknown as { compute: { calls: number } }
    const callsOf = (act: () => void) => {
      const before = compute.calls
      act()
      normals.update(renderer)
      return compute.calls - before
    }
    expect(callsOf(() => {})).toBe(1)
    expect(callsOf(() => {})).toBe(0)
    expect(callsOf(() => mesh.morphTargetInfluences!.fill(0.5))).toBe(1)
    expect(callsOf(() => {})).toBe(0)
    normals.dispose()
  })

  // three.js r186 and older frees storage buffers only when the renderer is disposed of.
  it.skipIf(Number.parseInt(REVISION, 10) < 187)('frees its GPU buffers', () => {
    const { memory } = renderer.info as unknown as { memory: { storageAttributes: number } }
    const before = memory.storageAttributes
    const normals = new RecomputedNormals(ball())
    normals.update(renderer)
    expect(memory.storageAttributes).toBeGreaterThan(before)
    normals.dispose()
    expect(memory.storageAttributes).toBe(before)
  })

  it('draws the same picture as the CPU, and restores the geometry', async () => {
    const face = await loadFace('/faces/human.glb')
    const { skin } = face
    const before = skin.geometry
    delete before.morphAttributes.normal
    skin.material = new MeshStandardMaterial({ roughness: 0.5 })
    const stage = faceScene(face, 'front')
    const draw = () => harness.renderBytes(stage.scene, stage.camera, WIDTH, HEIGHT)

    for (const [name, weight] of Object.entries(SMILE))
      skin.morphTargetInfluences![skin.morphTargetDictionary![name]] = weight
    const uncorrected = await draw()
    const cpuNormals = new CpuNormals(skin)
    cpuNormals.update()
    const expected = await draw()
    cpuNormals.dispose()
    const normals = new RecomputedNormals(skin)
    normals.update(renderer)
    expect(skin.geometry.morphAttributes.normal).toBeUndefined()
    // One channel value in a thousand may differ, because a pixel on an edge may take the colour of either triangle.
    const [found, changes] = [await draw(), largestDifference(uncorrected, expected)]
    expect(changes).toBeGreaterThan(40)
    expect(found.filter((value, i) => Math.abs(value - expected[i]) > 2).length).toBeLessThan(
      found.length / 1000,
    )
    normals.dispose()
    expect(skin.geometry).toBe(before)
    expect(largestDifference(await draw(), uncorrected)).toBe(0)
  })
})

describe('RecomputedNormals with WebGPURenderer on WebGL 2', () => {
  it('computes on the CPU', async () => {
    const fallback = await createHarness('webgpu on webgl2')
    const [mesh, copy] = [ball(), ball()]
    const [normals, expected] = [new RecomputedNormals(mesh), new CpuNormals(copy)]
    for (const { morphTargetInfluences } of [mesh, copy]) morphTargetInfluences!.fill(0.6)
    normals.update(fallback.renderer as WebGPURenderer)
    expected.update()
    expect(mesh.geometry.attributes.normal.array).toEqual(copy.geometry.attributes.normal.array)
    normals.dispose()
    fallback.dispose()
  })
})

/** Makes the morph targets of a mesh absolute: converts their offsets to positions. */
function absolute(mesh: Mesh): Mesh {
  const { geometry } = mesh
  const rest = geometry.attributes.position.array
  for (const target of geometry.morphAttributes.position!)
    target.array.set(target.array.map((value, i) => value + rest[i]))
  geometry.morphTargetsRelative = false
  return mesh
}
