import type { GrayImage, TensionDriver } from 'furrow'
import { addDrivers, Wrinkles, wrinklesOf } from 'furrow/webgpu'
import {
  Bone,
  type BufferGeometry,
  Euler,
  Float32BufferAttribute,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  Scene,
  Skeleton,
  SkinnedMesh,
  Vector3,
} from 'three'
import { Fn, instanceIndex, storage, uniform, vec3 } from 'three/tsl'
import { StorageBufferAttribute, type WebGPURenderer } from 'three/webgpu'
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { principalStretches, restInverse } from '../../packages/furrow/src/math/stretch.ts'
import { AreaTension } from '../../packages/furrow/src/three/webgpu/compute/area-tension.ts'
import { layer, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { deviceErrors } from './device-errors.ts'
import { createHarness, type Harness, type RendererName, squareCamera } from './harness.ts'

const full: GrayImage = { width: 1, height: 1, data: Uint8Array.of(255) }
const MEASURES = ['compression', 'stretch'] as const
/** Time limit for a measurement, milliseconds. Software rasterisers are slow. */
const TIMEOUT = 300_000
const disposers: (() => void)[] = []

let harness: Harness
let errors: string[]
const copyTo = vi.spyOn(AreaTension.prototype, 'copyTo')

async function begin(name: RendererName) {
  harness = await createHarness(name)
  errors = name === 'webgpu' ? deviceErrors(harness) : []
}

beforeEach(() => {
  copyTo.mockClear()
})
afterEach(() => {
  for (const dispose of disposers.splice(0)) dispose()
})

/** Adds wrinkles with tension drivers to a mesh. The returned function draws until the GPU has measured the tension. Then it returns the tension. */
function createMeasurement(mesh: Mesh, weights = full, direction?: [number, number]) {
  mesh.material = new MeshStandardMaterial()
  mesh.frustumCulled = false
  const layers = [layer('skin', 'detail', randomNormals(seeded(1), 2))]
  const wrinkles = new Wrinkles(mesh, { layers, areas: MEASURES.map((name) => ({ name, weights })) })
  const curve: TensionDriver['curve'] = [
    [-1, 0],
    [1, 1],
  ]
  addDrivers(
    wrinkles,
    MEASURES.map((measure) => ({
      type: 'tension',
      area: measure,
      measure,
      ...(direction && { direction }),
      curve,
    })),
  )
  disposers.push(() => wrinkles.dispose())
  const scene = new Scene()
  scene.add(mesh)
  return async () => {
    // The first frame may finish an earlier measurement. The second frame starts a measurement. Its result arrives before the third frame.
    for (let frame = 0; frame < 3; frame++) await harness.renderBytes(scene, squareCamera(), 4)
    const [compression, stretch] = MEASURES.map((name) => 2 * wrinkles.getActivation(name) - 1)
    return { compression, stretch }
  }
}

/** Creates a flat sheet of 1 x 1 units, divided into `side` x `side` squares. */
function sheet(side: number): BufferGeometry {
  return new PlaneGeometry(1, 1, side, side)
}

function deform({ attributes: { position } }: BufferGeometry, change: (point: Vector3) => Vector3) {
  const point = new Vector3()
  for (let i = 0; i < position.count; i++) {
    change(point.fromBufferAttribute(position, i))
    position.setXYZ(i, point.x, point.y, point.z)
  }
  position.needsUpdate = true
}

/** Computes the mean tension of all triangles in float64. The weight of a triangle is its area at rest times `weigh` at its centroid. */
function exactTension(mesh: Mesh, rest: ArrayLike<number>, weigh: (centroid: number[]) => number = () => 1) {
  const { count } = mesh.geometry.attributes.position
  const now = new Float64Array(3 * count)
  for (let i = 0; i < count; i++) mesh.getVertexPosition(i, new Vector3()).toArray(now, 3 * i)
  const triangles = mesh.geometry.index!.array
  const stretches = new Float64Array(2)
  let [sum, compression, stretch] = [0, 0, 0]
  for (let k = 0; k < triangles.length; k += 3) {
    const corners = [...triangles.slice(k, k + 3)] as [number, number, number]
    const [a, b, c] = corners.map((i) => new Vector3().fromArray(rest as number[], 3 * i))
    const restArea = b.clone().sub(a).cross(c.clone().sub(a)).length()
    const weight = restArea * weigh(a.add(b).add(c).divideScalar(3).toArray())
    principalStretches(stretches, restInverse(...corners, rest)!, 0, ...corners, now)
    sum += weight
    compression += weight * (1 - stretches[0])
    stretch += weight * (stretches[1] - 1)
  }
  return { compression: compression / sum, stretch: stretch / sum }
}

/** Computes the tension along a direction of the texture in float64. On the sheet, u and v increase along x and y. */
function exactTensionAlong(mesh: Mesh, rest: ArrayLike<number>, direction: [number, number]): number {
  const triangles = mesh.geometry.index!.array
  const step = new Vector3(...direction, 0).normalize()
  let [sum, stretch] = [0, 0]
  for (let k = 0; k < triangles.length; k += 3) {
    const corners = [...triangles.slice(k, k + 3)]
    const edges = (pointAt: (i: number) => Vector3) => {
      const [a, b, c] = corners.map(pointAt)
      return [b.sub(a), c.sub(a)]
    }
    const [e, f] = edges((i) => new Vector3().fromArray(rest as number[], 3 * i))
    const [moved, alsoMoved] = edges((i) => mesh.getVertexPosition(i, new Vector3()))
    const turn = e.clone().cross(f).z
    const [s, t] = [step.clone().cross(f).z / turn, e.clone().cross(step).z / turn]
    sum += turn
    stretch += turn * (moved.multiplyScalar(s).addScaledVector(alsoMoved, t).length() - 1)
  }
  return stretch / sum
}

/** Creates a skinned sheet. A joint rotates and scales the sheet. The weight of the joint rises from 0 at the lower edge to 1 at the upper edge. */
function skinnedSheet(): SkinnedMesh {
  const geometry = sheet(12)
  const { position } = geometry.attributes
  const headWeights = Array.from({ length: position.count }, (_, i) =>
    Math.min(1, Math.max(0, position.getY(i) + 0.5)),
  )
  geometry.setAttribute(
    'skinIndex',
    new Float32BufferAttribute(
      headWeights.flatMap(() => [0, 1, 0, 0]),
      4,
    ),
  )
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      headWeights.flatMap((weight) => [1 - weight, weight, 0, 0]),
      4,
    ),
  )
  const mesh = new SkinnedMesh(geometry)
  const [lower, head] = [new Bone(), new Bone()]
  mesh.position.set(0.2, 0, 0)
  mesh.add(lower.add(head))
  mesh.updateMatrixWorld(true)
  mesh.bind(new Skeleton([lower, head]))
  head.rotation.set(0.7, 0.2, 0.1)
  head.scale.set(0.9, 1.2, 1)
  head.position.y = -0.1
  return mesh
}

/** Adds two random blendshapes. */
function addTargets(mesh: Mesh): void {
  const random = seeded(9)
  const { position } = mesh.geometry.attributes
  mesh.geometry.morphTargetsRelative = true
  mesh.geometry.morphAttributes.position = [0, 1].map(
    () =>
      new Float32BufferAttribute(
        Float32Array.from({ length: 3 * position.count }, () => 0.05 * (random() - 0.5)),
        3,
      ),
  )
  mesh.updateMorphTargets()
}

describe('tension on WebGPU', () => {
  beforeAll(() => begin('webgpu'))
  afterEach(() => {
    expect(copyTo, 'measured on the GPU').toHaveBeenCalled()
    expect(errors).toEqual([])
  })
  afterAll(() => harness.dispose())

  it.each([1, 7, 40])(
    'is 0.20 for a sheet of %d x %d squares that is shortened by a fifth along x',
    async (side) => {
      const mesh = new Mesh(sheet(side))
      const measure = createMeasurement(mesh)
      deform(mesh.geometry, (point) => point.multiply(new Vector3(0.8, 1, 1)))
      const { compression, stretch } = await measure()
      expect(Math.abs(compression - 0.2)).toBeLessThan(0.005)
      expect(Math.abs(stretch)).toBeLessThan(1e-5)
    },
  )

  it.each([1, 7, 40])('is 0 for a rigid motion of a sheet of %d x %d squares', async (side) => {
    const mesh = new Mesh(sheet(side))
    const measure = createMeasurement(mesh)
    const turn = new Matrix4().makeRotationFromEuler(new Euler(0.4, 1.2, -2)).setPosition(0.3, -0.1, 0.7)
    deform(mesh.geometry, (point) => point.applyMatrix4(turn))
    for (const value of Object.values(await measure())) expect(Math.abs(value)).toBeLessThan(1e-5)
  })

  it('is 0 for a fold along an edge', async () => {
    const mesh = new Mesh(sheet(8))
    const measure = createMeasurement(mesh)
    deform(mesh.geometry, ({ x, y }) => new Vector3(Math.min(x, 0), y, Math.max(0, x)))
    for (const value of Object.values(await measure())) expect(Math.abs(value)).toBeLessThan(1e-5)
  })

  it.each([
    ['blendshapes', () => new Mesh(sheet(12)), true],
    ['a skeleton', skinnedSheet, false],
    ['a skeleton on top of blendshapes', skinnedSheet, true],
  ] as const)('is the mean over all triangles of a mesh deformed by %s', async (_, make, hasTargets) => {
    const mesh = make()
    if (hasTargets) addTargets(mesh)
    mesh.morphTargetInfluences?.splice(0, 2, 0.9, -0.4)
    const random = seeded(3)
    const size = 5
    const weights = {
      width: size,
      height: size,
      data: Uint8Array.from({ length: size * size }, () => 255 * random()),
    }
    const rest = mesh.geometry.attributes.position.array
    const found = await createMeasurement(mesh, weights)()
    const texel = (coordinate: number) => Math.floor(coordinate * size)
    // On this plane v increases with y, and row 0 of an image is at v = 0.
    const expected = exactTension(
      mesh,
      rest,
      ([x, y]) => weights.data[texel(y + 0.5) * size + texel(x + 0.5)],
    )
    expect(Math.abs(expected.compression)).toBeGreaterThan(0.02)
    expect(Math.abs(found.compression - expected.compression)).toBeLessThan(1e-4)
    expect(Math.abs(found.stretch - expected.stretch)).toBeLessThan(1e-4)
  })

  it.each([
    [1, 0],
    [0, 2],
    [1, -1],
  ])('along (%d, %d) in the texture is the change of length in this direction', async (...direction) => {
    const mesh = skinnedSheet()
    addTargets(mesh)
    mesh.morphTargetInfluences?.splice(0, 2, 0.9, -0.4)
    const rest = mesh.geometry.attributes.position.array
    const { compression, stretch } = await createMeasurement(mesh, full, direction)()
    const expected = exactTensionAlong(mesh, rest, direction)
    expect(Math.abs(expected)).toBeGreaterThan(0.004)
    expect(Math.abs(stretch - expected)).toBeLessThan(1e-4)
    expect(Math.abs(compression + expected)).toBeLessThan(1e-4)
  })

  it('follows a moving mesh, and is not measured while the mesh rests', async () => {
    const mesh = new Mesh(sheet(3))
    const measure = createMeasurement(mesh)
    for (const width of [0.9, 0.7, 1.1]) {
      const current = mesh.geometry.attributes.position.getX(3)
      deform(mesh.geometry, (point) => point.setX((point.x * width * 0.5) / current))
      expect((await measure()).compression).toBeCloseTo(Math.max(0, 1 - width), 4)
    }
    const { compute } = harness.renderer.info as unknown as { compute: { calls: number } }
    const before = compute.calls
    await measure()
    expect(compute.calls).toBe(before)
  })

  it('includes positions that a simulation writes on the GPU', async () => {
    const geometry = sheet(6)
    const { array, count } = geometry.attributes.position
    const position = new StorageBufferAttribute(array.slice(), 3)
    geometry.setAttribute('position', position)
    const mesh = new Mesh(geometry)
    const measure = createMeasurement(mesh)
    const width = uniform(1)
    const positions = storage(position, 'vec3', count)
    const rest = storage(new StorageBufferAttribute(array.slice(), 3), 'vec3', count)
    const shorten = Fn(() => {
      const restPosition = rest.element(instanceIndex)
      positions.element(instanceIndex).assign(restPosition.mul(vec3(width, 1, 1)) as never)
    })().compute(count)
    for (const fraction of [0.75, 0.6]) {
      width.value = fraction
      ;(harness.renderer as WebGPURenderer).compute(shorten)
      expect((await measure()).compression).toBeCloseTo(1 - fraction, 4)
    }
  })

  it('frees its GPU buffers, also while a result is pending', async () => {
    const { memory } = harness.renderer.info as unknown as { memory: { storageAttributes: number } }
    const before = memory.storageAttributes
    const mesh = new Mesh(sheet(4))
    await createMeasurement(mesh)()
    expect(memory.storageAttributes).toBeGreaterThan(before)
    deform(mesh.geometry, (point) => point.multiplyScalar(2))
    const scene = new Scene()
    scene.add(mesh)
    harness.renderer.render(scene, squareCamera())
    disposers.pop()!()
    await vi.waitFor(() => expect(memory.storageAttributes).toBe(before), TIMEOUT)
  })

  it('is measured on the CPU until the first result arrives', async () => {
    const mesh = new Mesh(sheet(4))
    createMeasurement(mesh)
    const scene = new Scene()
    scene.add(mesh)
    deform(mesh.geometry, (point) => point.multiply(new Vector3(0.7, 1, 1)))
    harness.renderer.render(scene, squareCamera())
    expect(2 * wrinklesOf(mesh)!.getActivation('compression') - 1).toBeCloseTo(0.3, 5)
    await vi.waitFor(() => {
      harness.renderer.render(scene, squareCamera())
      expect(copyTo).toHaveBeenCalled()
    }, TIMEOUT)
  })
})

describe('tension on WebGPU with a failing readback', () => {
  beforeAll(() => begin('webgpu'))
  afterAll(() => harness.dispose())

  it('is measured on the CPU, with one warning', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const renderer = harness.renderer as WebGPURenderer
    const read = vi.spyOn(renderer, 'getArrayBufferAsync').mockRejectedValue(new Error('no'))
    const mesh = new Mesh(sheet(4))
    const measure = createMeasurement(mesh)
    deform(mesh.geometry, (point) => point.multiply(new Vector3(0.7, 1, 1)))
    expect((await measure()).compression).toBeCloseTo(0.3, 5)
    expect(copyTo).not.toHaveBeenCalled()
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toMatch(/read back/)
    read.mockRestore()
    warn.mockRestore()
  })
})

describe('tension with WebGPURenderer on WebGL 2', () => {
  beforeAll(() => begin('webgpu on webgl2'))
  afterAll(() => harness.dispose())

  it('is measured on the CPU', async () => {
    const mesh = new Mesh(sheet(7))
    const measure = createMeasurement(mesh)
    deform(mesh.geometry, (point) => point.multiply(new Vector3(0.8, 1, 1)))
    expect((await measure()).compression).toBeCloseTo(0.2, 5)
    expect(copyTo).not.toHaveBeenCalled()
  })
})
