import type { Mesh } from 'three'
import { Fn, If, Loop, max, vec2 } from 'three/tsl'
import type { ComputeNode, Node, StorageBufferNode, WebGPURenderer } from 'three/webgpu'
import { formatProblem } from '../../../core/error.ts'
import { restMatrix } from '../../../math/stretch.ts'
import type { TensionSurface } from '../../sources/tension.ts'
import { localId, workgroupBarrier, workgroupId } from '../newer-nodes.ts'
import { Buffers, sharedArray, workgroups } from './buffers.ts'
import { DeformedPositions } from './deformed-positions.ts'

/** Number of invocations per workgroup. It is a multiple of the usual subgroup sizes, and within the limits of all WebGPU devices. */
const LANES = 64

/** Number of values per area in `AreaTension.values`. */
const PER_AREA = 2

/**
 * Measures on the GPU how much the skin under each area of wrinkles is compressed and stretched. The result is a mean over the triangles
 * under the area. Each triangle is weighted by its coverage, i.e. its surface area at rest times the area's weight at its centroid. The result
 * is read back asynchronously, and arrives one or two frames later.
 */
export class AreaTension {
  /**
   * Two means per area: `1 - smaller` and `larger - 1`, where `smaller` and `larger` are the principal stretches of a triangle. If a
   * direction is given, `smaller` and `larger` are both the stretch along this direction.
   */
  readonly values: Float32Array
  /** Whether `values` contains a measurement. */
  isReady = false
  readonly #mesh: Mesh
  readonly #lists: TriangleLists
  #work: Work | null = null
  #renderer: WebGPURenderer | null = null
  #isReading = false
  #isReleased = false
  #hasFailed = false

  /** @param surface mesh at rest, and the areas to measure. The result for an area that covers no triangle is 0. */
  constructor(mesh: Mesh, surface: TensionSurface) {
    this.#mesh = mesh
    this.#lists = listTriangles(surface)
    this.values = new Float32Array(PER_AREA * surface.measured.length)
  }

  /** Starts a measurement of the current pose, unless a measurement is pending or the pose has not changed. Never waits or throws. */
  update(renderer: WebGPURenderer): void {
    this.#isReleased = false
    if (renderer !== this.#renderer) this.#restart(renderer)
    if (this.#isReading || this.#hasFailed || this.#lists.corners.length === 0) return
    this.#work ??= createWork(this.#mesh, this.#lists)
    const { positions, passes, result } = this.#work
    if (!positions.update() && this.isReady) return
    renderer.compute(passes)
    this.#isReading = true
    renderer
      .getArrayBufferAsync(result.value)
      .then((buffer) => this.#store(renderer, new Float32Array(buffer)))
      .catch((error) => this.#fail(renderer, error))
      .finally(() => {
        this.#isReading = false
        if (this.#isReleased) this.#free()
      })
  }

  /** Copies the items of `values` at some indices. */
  copyTo(out: Float64Array, indices: readonly number[]): void {
    for (let i = 0; i < indices.length; i++) out[i] = this.values[indices[i]]
  }

  /** Frees the buffers when no readback is pending. The next update creates them again. */
  release(): void {
    this.#isReleased = true
    this.#renderer = null
    if (!this.#isReading) this.#free()
  }

  #restart(renderer: WebGPURenderer): void {
    this.#renderer = renderer
    this.isReady = false
    this.#hasFailed = false
  }

  #store(renderer: WebGPURenderer, values: Float32Array): void {
    if (renderer !== this.#renderer) return
    this.values.set(values)
    this.isReady = true
  }

  /** Stops measuring until another renderer draws the mesh. Callers then measure on the CPU. */
  #fail(renderer: WebGPURenderer, error: unknown): void {
    if (renderer !== this.#renderer) return
    this.isReady = false
    this.#hasFailed = true
    console.warn(
      formatProblem({
        who: 'Wrinkles',
        problem: 'tension could not be read back from the GPU',
        value: String(error),
        remedy: 'the CPU measures tension on a sample of triangles',
      }),
    )
  }

  #free(): void {
    this.#work?.dispose()
    this.#work = null
  }
}

/** The triangles of all areas, area by area. */
interface TriangleLists {
  /** Index of the first triangle of each area. The last item is the number of triangles. */
  starts: Uint32Array
  /** Four numbers per triangle: three vertex indices, and 0. */
  corners: Uint32Array
  /** Four numbers per triangle: three elements of the inverse rest matrix (see `restMatrix`), and the weight in the mean. */
  weighted: Float32Array
}

function listTriangles({ sampled: { positions, uvs, triangles }, measured }: TensionSurface): TriangleLists {
  const [corners, weighted]: number[][] = [[], []]
  const starts = new Uint32Array(measured.length + 1)
  for (const [area, { covered, direction }] of measured.entries()) {
    const found: { k: number; inverse: number[] }[] = []
    let sum = 0
    for (const [k, weight] of covered.entries()) {
      if (!(weight > 0)) continue
      const [a, b, c] = [3 * k, 3 * k + 1, 3 * k + 2].map((corner) => triangles[corner])
      const inverse = restMatrix(a, b, c, { positions, uvs, direction })
      if (!inverse) continue
      found.push({ k, inverse })
      sum += weight
    }
    for (const { k, inverse } of found) {
      corners.push(triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2], 0)
      weighted.push(...inverse, covered[k] / sum)
    }
    starts[area + 1] = corners.length / 4
  }
  return { starts, corners: Uint32Array.from(corners), weighted: Float32Array.from(weighted) }
}

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

/**
 * Creates the compute pass that computes the means, with one workgroup per area. Each invocation sums every `LANES`th triangle of the area, and
 * a tree reduction adds the sums.
 */
function meanOf(
  positions: StorageBufferNode<'vec4'>,
  lists: TriangleLists,
  result: StorageBufferNode<'vec2'>,
  buffers: Buffers,
): ComputeNode {
  const areas = lists.starts.length - 1
  const [bounds, corners, weighted] = [
    buffers.create('uint', lists.starts),
    buffers.create('uvec4', lists.corners),
    buffers.create('vec4', lists.weighted),
  ]
  const sums = sharedArray('vec2', LANES)
  const lane = localId.x
  return Fn(() => {
    const area = workgroupId.x
    const sum = vec2(0).toVar()
    const range = {
      start: bounds.element(area).add(lane),
      end: bounds.element(area.add(1)),
      type: 'uint',
      condition: '<',
      update: LANES,
    } as const
    Loop(range, ({ i: k }) => {
      const corner = corners.element(k).toVar()
      const triangle = weighted.element(k).toVar()
      const [a, b, c] = (['x', 'y', 'z'] as const).map((axis) => positions.element(corner[axis]).xyz)
      sum.addAssign(changeOf(b.sub(a), c.sub(a), triangle).mul(triangle.w))
    })
    sums.element(lane).assign(sum)
    workgroupBarrier()
    for (let half = LANES / 2; half >= 1; half /= 2) {
      If(lane.lessThan(half), () => {
        sums.element(lane).addAssign(sums.element(lane.add(half)))
      })
      workgroupBarrier()
    }
    If(lane.equal(0), () => {
      result.element(area).assign(sums.element(lane))
    })
  })().compute(workgroups(areas), [LANES])
}

/** Computes `(1 - smaller, larger - 1)` from the principal stretches of a triangle, see `principalStretches` in math/stretch. */
function changeOf(u: Node<'vec3'>, v: Node<'vec3'>, inverse: Node<'vec4'>): Node<'vec2'> {
  const [xx, xy, yy] = [inverse.x, inverse.y, inverse.z]
  // Columns of the deformation gradient; their dot products form the right Cauchy-Green tensor.
  const first = u.mul(xx).toVar()
  const second = u.mul(xy).add(v.mul(yy)).toVar()
  const [c00, c01, c11] = [first.dot(first), first.dot(second), second.dot(second)]
  const mean = c00.add(c11).mul(0.5).toVar()
  const spread = vec2(c00.sub(c11).mul(0.5), c01).length().toVar()
  const larger = mean.add(spread).sqrt().toVar()
  // `inverse.x` is 0 only if a direction is given. Both results are then the stretch along the direction.
  const smaller = xx.equal(0).select(larger, max(mean.sub(spread), 0).sqrt())
  return vec2(smaller.oneMinus(), larger.sub(1))
}
