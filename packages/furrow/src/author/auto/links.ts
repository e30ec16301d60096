import type { MorphDriver } from '../../drivers/morph/definition.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'
import { unroll } from './chart.ts'
import type { CreasedRegion, SkinRegion } from './crease.ts'
import { NearCreases } from './near.ts'
import { crossed } from './principal.ts'
import { Random } from './random.ts'
import { crossOf, type Surface } from './surface.ts'

/** A region with what drives it. */
export interface FittedRegion extends CreasedRegion {
  driver: MorphDriver
  /** Root mean square of its activation less the measured one, over the poses it was fitted to, 0..1; 0 where nothing is measured. */
  error: number
}

/** Triangles under a region, and the direction across its lines on each. */
interface Gauge {
  corners: Uint32Array
  /** The two shares by which the triangle's edges make up a vector across the line, and the weight of the triangle. */
  across: Float64Array
  weights: Float64Array
}

/** Compression that skin takes without a line, as a share of that of its cause. */
const ONSET = 0.12
/** Compression below which nothing is called a cause. */
const LEAST = 0.012
/** Share of what the strongest target does that counts as fully creased. */
const ALONE = 0.7
/** Links to a driver, at most, and the share of the strongest below which a target is none. */
const LINKS = 12
const FAINT = 0.08
/** Poses of several targets at once that a fit is held to. */
const POSES = 120
/** Bounds of a link's weight: of a cause, times its part; of another shape; and how much one may take away. */
const HIGHEST = 1.2
const BESIDE = 0.5
const LOWEST = -1
/** Shapes that stretch skin or roll it over bone; what they push together slides and does not fold. */
const TAUT = /^(jaw|tongue|eyeLook|eyeWide|cheekPuff|mouth(Left|Right|Close|Roll))/
const ROUNDS = 60
/** Draws weights that the poses leave open to 0 (Tikhonov). */
const RIDGE = 0.02

/**
 * Fits drivers to what the targets do to the skin under a region: each pose shortens it across the lines by so much, and the activation is
 * that as a share of what the region's cause does.
 *
 * @param names of the targets, in the order of `offsets`.
 * @returns undefined where no target shortens the skin.
 */
export function fitDriver(
  surface: Surface,
  creased: CreasedRegion,
  offsets: readonly Float64Array[],
  names: readonly string[],
  cause: ReadonlyMap<number, number>,
): FittedRegion | undefined {
  const { region, creases } = creased
  if (region.assumed !== undefined) {
    if (cause.size === 0) return undefined
    return { ...creased, driver: driverOf(region, linksOf(cause, names)), error: 0 }
  }
  const folds = creases.filter(({ isDimple }) => !isDimple)
  const gauge = gaugeOf(surface, region, folds)
  if (gauge.weights.length === 0) return undefined
  const measure = (pose: ReadonlyMap<number, number>) => compressionOf(surface, gauge, offsets, pose)
  const bounds = names.map((name) => boundOf(name, region))
  const lost = offsets.map((_, target) => measure(new Map([[target, 1]])))
  // Full is what the cause does; or nearly what a single target does that is believed, where that is more.
  const full = lost.reduce(
    (most, share, target) => Math.max(most, bounds[target]!.highest > 0 ? ALONE * share : 0),
    measure(cause),
  )
  if (full < LEAST) return undefined
  const alone = lost.map((share) => share / full)
  const strongest = alone.reduce((a, b) => Math.max(a, b), 0)
  const chosen = alone
    .map((share, target) => ({ share, target }))
    .filter(({ share }) => Math.abs(share) >= FAINT * strongest)
    .sort((a, b) => Math.abs(b.share) - Math.abs(a.share))
    .slice(0, LINKS)
    .map(({ target }) => target)
  const poses = drawPoses(chosen, cause)
  const wanted = poses.map((pose) => measure(pose) / full)
  const weights = leastSquares(
    poses.map((pose) => chosen.map((target) => pose.get(target) ?? 0)),
    wanted,
    chosen.map((target) => alone[target]!),
    chosen.map((target) => bounds[target]!),
  )
  const links = chosen
    .map((target, i) => ({ name: names[target]!, weight: roundWeight(weights[i]!) }))
    .filter(({ weight }) => Math.abs(weight) >= FAINT / 2)
  if (!links.some(({ weight }) => weight > 0)) return undefined
  const activation = (share: number) => Math.min(1, Math.max(0, (share - ONSET) / (1 - ONSET)))
  let squares = 0
  for (const [i, pose] of poses.entries()) {
    const said = chosen.reduce((sum, target, k) => sum + weights[k]! * (pose.get(target) ?? 0), 0)
    squares += (activation(said) - activation(wanted[i]!)) ** 2
  }
  const driver = driverOf(region, links)
  return { ...creased, driver, error: Math.sqrt(squares / poses.length) }
}

function driverOf({ name }: SkinRegion, targets: MorphDriver['targets']): MorphDriver {
  return {
    type: 'morph',
    area: name,
    targets,
    rule: 'sum',
    curve: [
      [ONSET, 0],
      [1, 1],
    ],
  }
}

function linksOf(pose: ReadonlyMap<number, number>, names: readonly string[]): MorphDriver['targets'] {
  return [...pose].map(([target, weight]) => ({ name: names[target]!, weight }))
}

/** Triangles within reach of a region's lines. */
function gaugeOf(
  { points, normals, corners }: Surface,
  { reach, share }: SkinRegion,
  creases: CreasedRegion['creases'],
): Gauge {
  const near = new NearCreases(
    creases,
    creases.map(() => reach),
  )
  const [chosen, across, weights]: number[][] = [[], [], []]
  const normal = new Float64Array(3)
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [corners[t]!, corners[t + 1]!, corners[t + 2]!]
    const middle = (k: number) => (points[3 * a + k]! + points[3 * b + k]! + points[3 * c + k]!) / 3
    let [closest, line, piece] = [Infinity, -1, 0]
    near.visit(
      middle(0),
      middle(1),
      middle(2),
      normals[3 * a]!,
      normals[3 * a + 1]!,
      normals[3 * a + 2]!,
      (index, distance, at) => {
        if (distance < closest) [closest, line, piece] = [distance, index, at]
      },
    )
    if (line < 0) continue
    const own = share?.(unroll(middle(0), middle(1), middle(2))) ?? 1
    const weight = own * (1 - closest / reach) * crossOf(points, a, b, c, normal)
    if (!(weight > 0)) continue
    const p = creases[line]!.points
    const way = [0, 1, 2].map((k) => p[3 * piece + 3 + k]! - p[3 * piece + k]!)
    const shares = edgeShares(points, a, b, c, crossed(normal, way))
    if (!shares) continue
    chosen.push(a, b, c)
    across.push(...shares)
    weights.push(weight)
  }
  return {
    corners: Uint32Array.from(chosen),
    across: Float64Array.from(across),
    weights: Float64Array.from(weights),
  }
}

/** A vector in a triangle's plane as p times its first edge and q times its second, at length 1. */
function edgeShares(points: ArrayLike<number>, a: number, b: number, c: number, v: readonly number[]) {
  let [uu, uw, ww, uv, wv, vv] = [0, 0, 0, 0, 0, 0]
  for (let k = 0; k < 3; k++) {
    const u = points[3 * b + k]! - points[3 * a + k]!
    const w = points[3 * c + k]! - points[3 * a + k]!
    uu += u * u
    uw += u * w
    ww += w * w
    uv += u * v[k]!
    wv += w * v[k]!
    vv += v[k]! * v[k]!
  }
  const det = uu * ww - uw * uw
  const scale = 1 / Math.sqrt(vv)
  const shares = [((ww * uv - uw * wv) / det) * scale, ((uu * wv - uw * uv) / det) * scale]
  return shares.every(Number.isFinite) ? shares : undefined
}

/** The mean share by which a pose shortens the skin across the lines; below 0 where it stretches it. */
function compressionOf(
  { points }: Surface,
  { corners, across, weights }: Gauge,
  offsets: readonly Float64Array[],
  pose: ReadonlyMap<number, number>,
): number {
  let [sum, total] = [0, 0]
  const moved = [...pose].map(([target, weight]) => ({ offset: offsets[target]!, weight }))
  for (let t = 0; t < weights.length; t++) {
    let square = 0
    for (let k = 0; k < 3; k++) {
      const place = (corner: number) => {
        const i = 3 * corners[3 * t + corner]! + k
        let value = points[i]!
        for (const { offset, weight } of moved) value += weight * offset[i]!
        return value
      }
      const from = place(0)
      square += (across[2 * t]! * (place(1) - from) + across[2 * t + 1]! * (place(2) - from)) ** 2
    }
    sum += weights[t]! * (1 - Math.sqrt(square))
    total += weights[t]!
  }
  return sum / total
}

/** Each target alone, full and half, the cause, and a few at once as faces do. */
function drawPoses(
  targets: readonly number[],
  cause: ReadonlyMap<number, number>,
): ReadonlyMap<number, number>[] {
  const numbers = new Random(1, 'poses')
  const poses: ReadonlyMap<number, number>[] = [cause]
  for (const target of targets) poses.push(new Map([[target, 1]]), new Map([[target, 0.5]]))
  while (poses.length < POSES) {
    const count = 2 + Math.floor(numbers.next() * 3)
    poses.push(
      new Map(
        Array.from({ length: count }, () => [
          targets[Math.floor(numbers.next() * targets.length)]!,
          numbers.next(),
        ]),
      ),
    )
  }
  return poses
}

/**
 * Weights w within bounds that bring A w nearest to b, and nearest to `usual` where A leaves them open: the normal equations, by
 * projected Gauss-Seidel (Murty: Linear Complementarity, 9.3).
 */
function leastSquares(
  rows: readonly number[][],
  b: readonly number[],
  usual: readonly number[],
  bounds: readonly Bound[],
): number[] {
  const n = usual.length
  const ridge = RIDGE * rows.length
  const matrix = usual.map((_, i) =>
    usual.map((_, j) => rows.reduce((sum, row) => sum + row[i]! * row[j]!, i === j ? ridge : 0)),
  )
  const right = usual.map((value, i) => rows.reduce((sum, row, k) => sum + row[i]! * b[k]!, ridge * value))
  const weights = usual.map(() => 0)
  for (let round = 0; round < ROUNDS; round++) {
    for (let i = 0; i < n; i++) {
      let rest = right[i]!
      for (let j = 0; j < n; j++) if (j !== i) rest -= matrix[i]![j]! * weights[j]!
      // What belongs to the cause does not work against it.
      const { highest, isCause } = bounds[i]!
      weights[i] = Math.min(Math.max(rest / matrix[i]![i]!, isCause ? 0 : LOWEST), highest)
    }
  }
  return weights
}

/** What a target may add at most: what belongs to the cause by its part in it. */
interface Bound {
  highest: number
  isCause: boolean
}

/** Shapes that are no cause of the region are believed less; those of the other side, and those that pull skin taut, not at all. */
function boundOf(name: string, { cause, name: area }: SkinRegion): Bound {
  const shape = canonicalTargetName(name)
  const own = Object.keys(cause).find((known) => [known, `${known}Left`, `${known}Right`].includes(shape))
  if (own !== undefined || name in cause) return { highest: HIGHEST * cause[own ?? name]!, isCause: true }
  const isOpposite = /Left$/.test(area) ? /Right$/.test(shape) : /Right$/.test(area) && /Left$/.test(shape)
  return { highest: isOpposite || TAUT.test(shape) ? 0 : BESIDE, isCause: false }
}

/** A link's weight as it is written: further decimals only lengthen the file. */
export function roundWeight(weight: number): number {
  return Math.round(1000 * weight) / 1000
}
