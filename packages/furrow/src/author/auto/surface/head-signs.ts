import { length3 } from '../../../math/vector.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { TargetHints } from './stand-ins.ts'

/** Kinds of blendshapes that only faces have. */
const FACE_KINDS = new Set(['expression', 'viseme', 'emotion'])

/** Fraction of a target's largest displacement above which a point counts as moved. */
const MOVED = 0.1
/**
 * Maximum distance between lips at rest, and minimum distance by which a target parts them, as fractions of the moved area's square root.
 */
const CLOSED = 0.06
const PARTED = 0.12
/** Maximum cosine between the normals of skin that faces other skin. */
const FACING = 0.2
/** Minimum number of point pairs on lips. */
const MIN_PAIRS = 4

/** Returns whether a skin is a head, even without landmarks: targets are named like facial shapes, or one opens a mouth. */
export function isHead(surface: SkinSurface, offsets: readonly Float64Array[], hints: TargetHints): boolean {
  const isNamed = hints.some((hint) => hint !== undefined && FACE_KINDS.has(hint.kind))
  return isNamed || offsets.some((offset) => opensMouth(surface, offset))
}

/** Returns whether a target parts skin that closely faces other skin. */
function opensMouth({ points, normals, areas }: SkinSurface, offset: Float64Array): boolean {
  const distances = areas.map((_, i) => length3(offset[3 * i], offset[3 * i + 1], offset[3 * i + 2]))
  const largest = distances.reduce((a, b) => Math.max(a, b), 0)
  const area = areas.reduce((sum, area, i) => (distances[i] > MOVED * largest ? sum + area : sum), 0)
  const [closed, parted] = [CLOSED * Math.sqrt(area), PARTED * Math.sqrt(area)]
  // The faster of two points makes at least half of the gap.
  if (!(largest > parted / 2)) return false
  const cellOf = (i: number, k: number, step: number) => Math.floor(points[3 * i + k] / closed) + step
  const cells = new Map<string, number[]>()
  for (let i = 0; i < areas.length; i++) {
    const key = [0, 1, 2].map((k) => cellOf(i, k, 0)).join()
    const cell = cells.get(key)
    if (cell) cell.push(i)
    else cells.set(key, [i])
  }
  let pairs = 0
  for (let i = 0; i < areas.length; i++) {
    if (distances[i] <= parted / 2) continue
    const isParted = (j: number) =>
      dotOf(normals, i, j) < FACING && gapOf(points, i, j) < closed && gapOf(offset, i, j) > parted
    const found = STEPS.some(([x, y, z]) =>
      cells.get(`${cellOf(i, 0, x)},${cellOf(i, 1, y)},${cellOf(i, 2, z)}`)?.some(isParted),
    )
    if (found && ++pairs === MIN_PAIRS) return true
  }
  return false
}

/** Offsets from a cell to itself and its neighbours. */
const STEPS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)))

function dotOf(vectors: Float64Array, i: number, j: number): number {
  return [0, 1, 2].reduce((sum, k) => sum + vectors[3 * i + k] * vectors[3 * j + k], 0)
}

function gapOf(vectors: Float64Array, i: number, j: number): number {
  const [x, y, z] = [0, 1, 2].map((k) => vectors[3 * i + k] - vectors[3 * j + k])
  return length3(x, y, z)
}
