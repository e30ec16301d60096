import { KdTree } from '../../../math/kd-tree.ts'
import { pointOffsets, type Skin, weldSurface } from '../../skin/surface.ts'

/** Maximum number of points. Denser surfaces are subsampled. */
const MAX_POINTS = 16_000
/** Maximum displacement, as a multiple of the surface's extent. Targets with larger displacements are broken and dropped. */
const MAX_OFFSET = 2

/** Points of the skin in the rest pose, and their displacements by targets (blendshapes). */
export interface MovingSurface {
  /** Packed xyz. */
  points: Float64Array
  /** Unit normals that point outwards. */
  normals: Float64Array
  areas: Float64Array
  /** Index of each point's connected component. */
  components: Uint32Array
  motions: Motion[]
}

/** Displacements by one target. */
export interface Motion {
  /** Index of the target. */
  target: number
  /** Displacement of each point, packed xyz. */
  offsets: Float64Array
  /** Length of each point's displacement. */
  distances: Float64Array
  /** Length of the largest displacement. */
  largest: number
}

/** Creates the surface of a skin. Drops targets that are broken or move nothing. Returns undefined if the surface is empty or not finite. */
export function movingSurface(skin: Skin): MovingSurface | undefined {
  const welded = weldSurface(skin)
  const size = extentOf(welded.points)
  if (!(size > 0 && size < Infinity)) return undefined
  const kept = usedPoints(welded.areas)
  const pick = (values: Float64Array) => pickPoints(values, kept)
  const allComponents = componentsOf(welded.neighbourStarts, welded.neighbours)
  const motions: Motion[] = []
  for (const [target, shape] of skin.targets.entries()) {
    const offsets = pick(pointOffsets(welded, shape))
    const distances = lengthsOf(offsets)
    const largest = distances.reduce((a, b) => Math.max(a, b), 0)
    if (largest > 1e-5 * size && largest <= MAX_OFFSET * size)
      motions.push({ target, offsets, distances, largest })
  }
  const points = pick(welded.points)
  const normals = pick(welded.normals)
  const areas = Float64Array.from(kept, (point) => welded.areas[point])
  orient(points, normals, areas)
  return { points, normals, areas, components: kept.map((point) => allComponents[point]), motions }
}

export function treeOf(points: Float64Array, indices: ArrayLike<number>, most = 1): KdTree {
  return new KdTree(pickPoints(points, indices), 3, most)
}

/** Returns the packed xyz values at the given indices. */
export function pickPoints(values: Float64Array, indices: ArrayLike<number>): Float64Array {
  const out = new Float64Array(3 * indices.length)
  for (let i = 0; i < indices.length; i++)
    for (let k = 0; k < 3; k++) out[3 * i + k] = values[3 * indices[i] + k]
  return out
}

export function distanceBetween(points: Float64Array, i: number, j: number): number {
  const x = points[3 * i] - points[3 * j]
  const y = points[3 * i + 1] - points[3 * j + 1]
  const z = points[3 * i + 2] - points[3 * j + 2]
  return Math.sqrt(x * x + y * y + z * z)
}

function usedPoints(areas: Float64Array): Uint32Array {
  const used: number[] = []
  for (let i = 0; i < areas.length; i++) if (areas[i] > 0) used.push(i)
  const step = Math.ceil(used.length / MAX_POINTS)
  return Uint32Array.from(used.filter((_, i) => i % step === 0))
}

function extentOf(points: Float64Array): number {
  let extent = 0
  for (let k = 0; k < 3; k++) {
    let [low, high] = [Infinity, -Infinity]
    for (let i = k; i < points.length; i += 3) {
      if (!Number.isFinite(points[i])) return Number.NaN
      low = Math.min(low, points[i])
      high = Math.max(high, points[i])
    }
    extent = Math.max(extent, high - low)
  }
  return extent
}

function lengthsOf(vectors: Float64Array): Float64Array {
  const out = new Float64Array(vectors.length / 3)
  for (let i = 0; i < out.length; i++) {
    const [x, y, z] = [vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]]
    out[i] = Math.sqrt(x * x + y * y + z * z)
  }
  return out
}

/** Flips all normals if they point inwards, which happens if a file mirrors its mesh. */
function orient(points: Float64Array, normals: Float64Array, areas: Float64Array): void {
  const middle = [0, 0, 0]
  let total = 0
  for (let i = 0; i < areas.length; i++) {
    for (let k = 0; k < 3; k++) middle[k] += areas[i] * points[3 * i + k]
    total += areas[i]
  }
  let flux = 0
  for (let i = 0; i < areas.length; i++) {
    for (let k = 0; k < 3; k++)
      flux += areas[i] * (points[3 * i + k] - middle[k] / total) * normals[3 * i + k]
  }
  if (flux < 0) for (let i = 0; i < normals.length; i++) normals[i] = -normals[i]
}

/** Returns each point's connected component. The index of a component is the index of its first point. */
function componentsOf(starts: Uint32Array, neighbours: Uint32Array): Uint32Array {
  const count = starts.length - 1
  const components = new Uint32Array(count).fill(count)
  const open: number[] = []
  for (let first = 0; first < count; first++) {
    if (components[first] < count) continue
    components[first] = first
    open.push(first)
    for (let point = open.pop(); point !== undefined; point = open.pop()) {
      for (let k = starts[point]; k < starts[point + 1]; k++) {
        if (components[neighbours[k]] < count) continue
        components[neighbours[k]] = first
        open.push(neighbours[k])
      }
    }
  }
  return components
}
