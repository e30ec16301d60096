import { length3 } from '../../../math/vector.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { TargetHints } from './stand-ins.ts'

/** Kinds of blendshapes that only faces have. */
const FACE_KINDS = new Set(['expression', 'viseme', 'emotion'])

/** A point counts as moved if its displacement exceeds this fraction of the target's largest displacement. */
const MOVED = 0.1
// Distances are fractions of the square root of the area that a target moves.
/** Maximum distance between the lips at rest. */
const CLOSED = 0.06
/** Minimum distance that a target adds between the lips. */
const PARTED = 0.12
/** Maximum cosine between the normals of two lips that face each other. */
const FACING = 0.2
/** Minimum number of pairs of points on opposite lips. */
const MIN_PAIRS = 4

/** Returns whether a skin is a head: whether a target (blendshape) is named like a facial shape, or opens a mouth. */
export function isHead(surface: SkinSurface, offsets: readonly Float64Array[], hints: TargetHints): boolean {
  const isNamed = hints.some((hint) => hint !== undefined && FACE_KINDS.has(hint.kind))
  return isNamed || offsets.some((offset) => opensMouth(surface, offset))
}

/** Returns whether a target pulls apart pairs of points that are close at rest and face each other, as on lips. */
function opensMouth({ points, normals, areas }: SkinSurface, offset: Float64Array): boolean {
  const distances = areas.map((_, i) => length3(offset[3 * i], offset[3 * i + 1], offset[3 * i + 2]))
  const largest = distances.reduce((a, b) => Math.max(a, b), 0)
  const area = areas.reduce((sum, area, i) => (distances[i] > MOVED * largest ? sum + area : sum), 0)
  const [closed, parted] = [CLOSED * Math.sqrt(area), PARTED * Math.sqrt(area)]
  // When a target pulls two points apart, at least one of them moves by half the added distance or more.
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

/** Steps in x, y and z from a cell to itself and its 26 neighbours. */
const STEPS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)))

function dotOf(vectors: Float64Array, i: number, j: number): number {
  return [0, 1, 2].reduce((sum, k) => sum + vectors[3 * i + k] * vectors[3 * j + k], 0)
}

function gapOf(vectors: Float64Array, i: number, j: number): number {
  const [x, y, z] = [0, 1, 2].map((k) => vectors[3 * i + k] - vectors[3 * j + k])
  return length3(x, y, z)
}
