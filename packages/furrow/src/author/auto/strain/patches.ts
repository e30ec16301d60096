import type { SkinSurface } from '../../skin/surface.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { hasTensor, TENSOR_SIZE } from '../surface/tensors.ts'
import { poseStrain } from './pose-strain.ts'
import { pointCompression } from './principal.ts'

/** The compression is smoothed with this standard deviation in millimetres. It is large, so that noise creates no patches. */
const PATCH_SIGMA = 5
/** Minimum compression of the skin in a patch. On faces, less compression is enough, because the places of lines are known from anatomy. */
export const MIN_PATCH_COMPRESSION = 0.07
/** Minimum area of a patch in square millimetres. */
const MIN_PATCH_AREA = 80
/** Two patches count as one if at least this fraction of the smaller one overlaps the larger one. */
const SAME = 0.5

/** Connected part of the skin that a blendshape compresses. */
export interface CompressedPatch {
  /** Indices of the points in the surface. */
  points: ReadonlySet<number>
  /** Area in square millimetres. */
  area: number
  /** Index of the blendshape. If several blendshapes compress the same skin, this is the one with the largest patch. */
  target: number
  /** Result of `compressionTensors` for these points, in the order of `points`. */
  tensors: Float64Array
}

/**
 * Finds the connected patches that single blendshapes compress, sorted from large to small. Of patches that count as one (see `SAME`), only the
 * largest is kept.
 */
export function findPatches(
  { surface, offsets, names }: Pick<PreparedSkin, 'surface' | 'offsets' | 'names'>,
  maxPatches: number,
  report: (fraction: number) => void,
): CompressedPatch[] {
  const candidates = names.flatMap((_, target) => {
    report(target / names.length)
    const tensors = poseStrain(surface, offsets, new Map([[target, 1]]), PATCH_SIGMA, names.length)
    return patchesOf(surface, tensors, target)
  })
  const chosen: CompressedPatch[] = []
  for (const patch of candidates.sort((a, b) => b.area - a.area)) {
    if (chosen.length === maxPatches) break
    if (!chosen.some((larger) => isSame(patch, larger))) chosen.push(patch)
  }
  return chosen
}

/** Expands the tensors of a patch to all points of the surface. Points outside the patch get 0. */
export function patchTensors({ points, tensors }: CompressedPatch, pointCount: number): Float64Array {
  const all = new Float64Array(TENSOR_SIZE * pointCount)
  let offset = 0
  for (const point of points) {
    all.set(tensors.subarray(offset, offset + TENSOR_SIZE), TENSOR_SIZE * point)
    offset += TENSOR_SIZE
  }
  return all
}

/** Returns the connected components of the points with at least `MIN_PATCH_COMPRESSION`. */
function patchesOf(surface: SkinSurface, tensors: Float64Array, target: number): CompressedPatch[] {
  const { areas, neighbourStarts, neighbours } = surface
  const open = new Set<number>()
  for (let i = 0; i < areas.length; i++)
    if (hasTensor(tensors, i) && pointCompression(surface, tensors, i) >= MIN_PATCH_COMPRESSION) open.add(i)
  const patches: CompressedPatch[] = []
  for (const first of open) {
    const points = new Set([first])
    open.delete(first)
    for (const point of points) {
      for (const next of neighbours.subarray(neighbourStarts[point], neighbourStarts[point + 1]))
        if (open.delete(next)) points.add(next)
    }
    const area = [...points].reduce((sum, point) => sum + areas[point], 0)
    if (area < MIN_PATCH_AREA) continue
    patches.push({ points, area, target, tensors: tensorsOf(tensors, points) })
  }
  return patches
}

function tensorsOf(tensors: Float64Array, points: ReadonlySet<number>): Float64Array {
  const out = new Float64Array(TENSOR_SIZE * points.size)
  let offset = 0
  for (const point of points) {
    out.set(tensors.subarray(TENSOR_SIZE * point, TENSOR_SIZE * (point + 1)), offset)
    offset += TENSOR_SIZE
  }
  return out
}

function isSame(a: CompressedPatch, b: CompressedPatch): boolean {
  let common = 0
  for (const point of a.points) if (b.points.has(point)) common++
  return common >= SAME * Math.min(a.points.size, b.points.size)
}
