import type { Mesh } from 'three'
import { Fn, If, Loop, localId, max, vec2, workgroupArray, workgroupBarrier, workgroupId } from 'three/tsl'
import type { ComputeNode, Node, StorageBufferNode, WebGPURenderer } from 'three/webgpu'
import { sentence } from '../../core/error.ts'
import { restInverse } from '../../math/stretch.ts'
import type { TenseMesh } from '../sources/tension.ts'
import { at, Buffers } from './buffers.ts'
import { DeformedPositions } from './deformed-positions.ts'

/** Invocations that share an area's triangles; also the most that every WebGPU device and subgroup size suits. */
const LANES = 64

/** Numbers of an area in `values`. */
const PER_AREA = 2

/**
 * Measures on the graphics card how far the skin under each area is pushed together and pulled apart: the mean over all of its
 * triangles, by weight times surface at rest, however the mesh is deformed. Each area has a workgroup of its own: there are few
 * areas and thousands of triangles under each, which a single invocation would walk one by one. The result comes back one or two
 * frames later; nothing waits for it.
 */
export class AreaTension {
  /** Of each area the mean of 1 - the smaller principal stretch and of the larger one - 1. */
  readonly values: Float32Array
  /** Whether `values` are a measurement. */
  isReady = false
  readonly #mesh: Mesh
  readonly #lists: TriangleLists
  #work: Work | null = null
  #renderer: WebGPURenderer | null = null
  #isReading = false
  #isDisposed = false
  #hasFailed = false

  /** @param tense the mesh at rest; areas that cover nothing of it measure 0. */
  constructor(mesh: Mesh, tense: TenseMesh) {
    this.#mesh = mesh
    this.#lists = listTriangles(tense)
    this.values = new Float32Array(PER_AREA * tense.covered.length)
  }

  /** Starts to measure the mesh as it is now, unless a measurement is under way or nothing has changed. Never waits, never throws. */
  update(renderer: WebGPURenderer): void {
    if (renderer !== this.#renderer) this.#begin(renderer)
    if (this.#isReading || this.#hasFailed || this.#lists.corners.length === 0) return
    this.#work ??= createWork(this.#mesh, this.#lists)
    const { positions, passes, result } = this.#work
    if (!positions.take() && this.isReady) return
    renderer.compute(passes)
    this.#isReading = true
    renderer
      .getArrayBufferAsync(result.value)
      .then((buffer) => this.#take(renderer, new Float32Array(buffer)))
      .catch((error) => this.#fail(renderer, error))
      .finally(() => {
        this.#isReading = false
        if (this.#isDisposed) this.#free()
      })
  }

  /** Copies measurements, by their indices in `values`. */
  copyTo(out: Float64Array, indices: readonly number[]): void {
    for (let i = 0; i < indices.length; i++) out[i] = this.values[indices[i]]
  }

  /** Frees what the graphics card holds, once nothing is read from it any more. */
  dispose(): void {
    this.#isDisposed = true
    if (!this.#isReading) this.#free()
  }

  #begin(renderer: WebGPURenderer): void {
    this.#renderer = renderer
    this.isReady = false
    this.#hasFailed = false
  }

  #take(renderer: WebGPURenderer, values: Float32Array): void {
    if (renderer !== this.#renderer) return
    this.values.set(values)
    this.isReady = true
  }

  /** Leaves it to the processor until another renderer draws the mesh. */
  #fail(renderer: WebGPURenderer, error: unknown): void {
    if (renderer !== this.#renderer || this.#isDisposed) return
    this.isReady = false
    this.#hasFailed = true
    console.warn(
      sentence({
        who: 'Wrinkles',
        what: 'tension could not be read back from the graphics card',
        value: String(error),
        remedy: 'the processor measures it on a sample of triangles',
      }),
    )
  }

  #free(): void {
    this.#work?.dispose()
    this.#work = null
  }
}

/** Triangles by area: corners, and in four numbers each the inverse at rest and the share in the area. */
interface TriangleLists {
  starts: Uint32Array
  corners: Uint32Array
  shares: Float32Array
}

function listTriangles({ sampled: { positions, triangles }, covered }: TenseMesh): TriangleLists {
  const [corners, shares]: number[][] = [[], []]
  const starts = new Uint32Array(covered.length + 1)
  for (const [area, ofArea] of covered.entries()) {
    const found: { k: number; inverse: number[] }[] = []
    let sum = 0
    for (const [k, share] of ofArea.entries()) {
      const [a, b, c] = [3 * k, 3 * k + 1, 3 * k + 2].map((corner) => triangles[corner])
      const inverse = share > 0 && restInverse(a, b, c, positions)
      if (!inverse) continue
      found.push({ k, inverse })
      sum += share
    }
    for (const { k, inverse } of found) {
      corners.push(triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2], 0)
      shares.push(...inverse, ofArea[k] / sum)
    }
    starts[area + 1] = corners.length / 4
  }
  return { starts, corners: Uint32Array.from(corners), shares: Float32Array.from(shares) }
}

/** What the graphics card does and holds. */
interface Work {
  positions: DeformedPositions
  passes: ComputeNode[]
  result: StorageBufferNode<'vec2'>
  dispose(): void
}

function createWork(mesh: Mesh, lists: TriangleLists): Work {
  const positions = new DeformedPositions(mesh, true)
  const buffers = new Buffers()
  const areas = lists.starts.length - 1
  const result = buffers.create('vec2', new Float32Array(PER_AREA * areas))
  const mean = meanOf(positions.node, lists, result, buffers)
  return {
    positions,
    passes: [...positions.passes, mean],
    result,
    dispose() {
      mean.dispose()
      positions.dispose()
      buffers.dispose()
    },
  }
}

/** Sums an area's triangles, of which each lane takes every `LANES`th, and then the lanes two by two. */
function meanOf(
  positions: StorageBufferNode<'vec4'>,
  lists: TriangleLists,
  result: StorageBufferNode<'vec2'>,
  buffers: Buffers,
): ComputeNode {
  const areas = lists.starts.length - 1
  const [bounds, corners, shares] = [
    buffers.create('uint', lists.starts),
    buffers.create('uvec4', lists.corners),
    buffers.create('vec4', lists.shares),
  ]
  const sums = workgroupArray('vec2', LANES) as unknown as StorageBufferNode<'vec2'>
  const lane = localId.x
  // As many workgroups as areas; the types know numbers of invocations only.
  const workgroups = [areas, 1, 1] as unknown as number
  return Fn(() => {
    const area = workgroupId.x
    const sum = vec2(0).toVar()
    const range = {
      start: at(bounds, area).add(lane) as Node<'uint'>,
      end: at(bounds, area.add(1)),
      type: 'uint',
      condition: '<',
      update: LANES,
    } as const
    Loop(range, ({ i: k }) => {
      const corner = at(corners, k).toVar()
      const share = at(shares, k).toVar()
      const [a, b, c] = (['x', 'y', 'z'] as const).map(
        (axis) => at(positions, corner[axis]).xyz as Node<'vec3'>,
      )
      sum.addAssign(changeOf(b.sub(a), c.sub(a), share).mul(share.w))
    })
    at(sums, lane).assign(sum)
    workgroupBarrier()
    for (let half = LANES / 2; half >= 1; half /= 2) {
      If(lane.lessThan(half), () => {
        at(sums, lane).addAssign(at(sums, lane.add(half)))
      })
      workgroupBarrier()
    }
    If(lane.equal(0), () => {
      at(result, area).assign(at(sums, lane))
    })
  })().compute(workgroups, [LANES])
}

/** `principalStretches` of math/stretch: 1 - the smaller one, and the larger one - 1. */
function changeOf(u: Node<'vec3'>, v: Node<'vec3'>, inverse: Node<'vec4'>): Node<'vec2'> {
  const [xx, xy, yy] = [inverse.x, inverse.y, inverse.z]
  // The edges as they would be were the triangle at rest the unit one: their products are the Cauchy-Green tensor.
  const first = u.mul(xx).toVar() as Node<'vec3'>
  const second = u.mul(xy).add(v.mul(yy)).toVar() as Node<'vec3'>
  const [c00, c01, c11] = [first.dot(first), first.dot(second), second.dot(second)]
  const mean = c00.add(c11).mul(0.5).toVar()
  const spread = vec2(c00.sub(c11).mul(0.5) as Node<'float'>, c01)
    .length()
    .toVar()
  const smaller = max(mean.sub(spread), 0).sqrt()
  return vec2(smaller.oneMinus() as Node<'float'>, mean.add(spread).sqrt().sub(1) as Node<'float'>)
}
