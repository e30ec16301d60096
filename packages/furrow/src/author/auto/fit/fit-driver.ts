import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import { Rng } from '../../../math/rng.ts'
import { clamp, rounded } from '../../../math/scalar.ts'
import { length3 } from '../../../math/vector.ts'
import { shapeNameOf } from '../../shapes/names/hint.ts'
import type { SkinRegion } from '../anatomy/region.ts'
import type { CreasedRegion } from '../lines/crease.ts'
import type { Pose } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { makeGauge, measureCompression, vectorsAcross } from './gauge.ts'
import { type Bounds, boundedLeastSquares } from './least-squares.ts'

/** Region of skin, with the driver that computes the activation of its area of influence. */
export interface FittedRegion extends CreasedRegion {
  driver: MorphDriver
  /** Root mean square error of the driver's activation over the poses that it was fitted to, 0..1; 0 if the driver was not fitted. */
  error: number
}

/** Region that gets no area, with the reason. */
export interface MissingRegion {
  /** Name that the region's area would have. */
  name: string
  /** Reason: a clause for a message. */
  reason: string
}

/** Compression up to which skin shows no line, as a fraction of the compression at full activation. */
const ONSET = 0.12
/** Regions whose skin loses less than this fraction of its length across the lines get no driver. */
const MIN_COMPRESSION = 0.012
/** Regions whose blendshapes move no skin farther than this get no driver, in millimetres, even if their compression is assumed. */
const MIN_MOTION = 1
/** The compression at full activation is at least this fraction of the largest compression by a single target (blendshape). */
const SINGLE_TARGET = 0.7
const MAX_TARGETS = 12
/** Minimum compression by a target that a driver uses, as a fraction of the strongest target's compression. */
const NEGLIGIBLE = 0.08
/** Number of poses that a driver is fitted to. Most poses are combinations of targets. */
const POSES = 120
/** Maximum weight that a driver gives to a target of `SkinRegion.cause`, as a multiple of the target's weight in `cause`. */
const MAX_CAUSE = 1.2
/** Maximum weight that a driver gives to other targets. */
const MAX_OTHER = 0.5
/** Minimum weight that a driver gives to other targets. */
const MIN_WEIGHT = -1
/** Shapes that stretch skin or roll it over bone. If such a shape pushes skin together, the skin slides instead of folding. */
const TAUT = /^(jaw|tongue|eyeLook|eyeWide|cheekPuff|mouth(Left|Right|Close|Roll))/

/**
 * Fits a region's driver to the compression of skin by targets. The driver should activate the area in each pose according to the measured
 * compression across the lines, relative to the compression at full activation.
 *
 * @param cause pose that creases the region most (`SkinRegion.cause`).
 * @returns the region with its driver. If the region cannot crease, returns the reason: a clause for a message.
 */
export function fitDriver(
  {
    surface,
    offsets,
    names,
    known,
    hints,
  }: Pick<PreparedSkin, 'surface' | 'offsets' | 'names' | 'known' | 'hints'>,
  creased: CreasedRegion,
  cause: Pose,
): FittedRegion | string {
  const { region, folds, creases } = creased
  const shapes = Object.keys(region.cause).join(', ')
  if (cause.size === 0) return `no blendshape is ${(region.shapes ?? []).join(' or ')} or stands in for it`
  if (creases.length === 0)
    return 'film' in region
      ? `with ${shapes}, the skin is compressed too little to fold`
      : 'the mesh has no skin where the lines begin'
  if (region.assumedCompression !== undefined) {
    const motion = largestMotion(offsets, cause)
    if (motion < MIN_MOTION) return `${shapes} move the skin by at most ${rounded(motion, 10)} mm`
    const targets = [...cause].map(([target, weight]) => ({ name: names[target], weight }))
    return { ...creased, driver: driverOf(region, targets), error: 0 }
  }
  const gauge = makeGauge(surface, region, folds)
  if (!gauge) return 'the mesh has no skin beside the lines'
  const rest = vectorsAcross(gauge, surface.points)
  const bounds = known.map((name, i) => boundsOf(name, shapeNameOf(name, hints[i]), region))
  const probe = { vectors: new Float64Array(rest.length), weight: 1 }
  const compressions = offsets.map((offset) => {
    vectorsAcross(gauge, offset, probe.vectors)
    return measureCompression(gauge, rest, [probe])
  })
  /** Cache of `vectorsAcross` for the targets that poses use. */
  const measured = new Map<number, Float64Array>()
  const vectorsOf = (target: number) => {
    const vectors = measured.get(target) ?? vectorsAcross(gauge, offsets[target])
    measured.set(target, vectors)
    return vectors
  }
  const measure = (pose: Pose) => {
    const moved = [...pose].map(([target, weight]) => ({ vectors: vectorsOf(target), weight }))
    return measureCompression(gauge, rest, moved)
  }
  // Compression at full activation: the cause's compression, or a fraction of the largest compression by a single target if this is larger.
  const full = compressions.reduce(
    (largest, value, target) => Math.max(largest, bounds[target][1] > 0 ? SINGLE_TARGET * value : 0),
    measure(cause),
  )
  if (Math.min(full, creased.compression) < MIN_COMPRESSION) {
    const most = percent(Math.max(0, Math.min(full, creased.compression)))
    return `with ${shapes}, the skin shortens by ${most} across the lines; creases begin at ${percent(MIN_COMPRESSION)}`
  }
  const relative = compressions.map((value) => value / full)
  const chosen = strongestTargets(relative)
  const poses = drawPoses(chosen, cause)
  const wanted = poses.map((pose) => measure(pose) / full)
  const weights = boundedLeastSquares(
    poses.map((pose) => chosen.map((target) => pose.get(target) ?? 0)),
    wanted,
    chosen.map((target) => relative[target]),
    chosen.map((target) => bounds[target]),
  )
  const targets = chosen
    .map((target, i) => ({ name: names[target], weight: roundWeight(weights[i]) }))
    .filter(({ weight }) => Math.abs(weight) >= NEGLIGIBLE / 2)
  if (!targets.some(({ weight }) => weight > 0))
    return `with ${shapes}, the skin creases no more than with other blendshapes`
  let squares = 0
  for (const [i, pose] of poses.entries()) {
    const fitted = chosen.reduce((sum, target, k) => sum + weights[k] * (pose.get(target) ?? 0), 0)
    squares += (activationOf(fitted) - activationOf(wanted[i])) ** 2
  }
  return { ...creased, driver: driverOf(region, targets), error: Math.sqrt(squares / poses.length) }
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

/** Evaluates the curve of the drivers that `fitDriver` creates. The compression is relative to the compression at full activation. */
export function activationOf(relativeCompression: number): number {
  return clamp((relativeCompression - ONSET) / (1 - ONSET), 0, 1)
}

/** Returns the indices of the targets that change the compression most, whether they increase or reduce it. */
function strongestTargets(relative: readonly number[]): number[] {
  const largest = relative.reduce((a, b) => Math.max(a, b), 0)
  return relative
    .map((compression, target) => ({ compression, target }))
    .filter(({ compression }) => Math.abs(compression) >= NEGLIGIBLE * largest)
    .sort((a, b) => Math.abs(b.compression) - Math.abs(a.compression))
    .slice(0, MAX_TARGETS)
    .map(({ target }) => target)
}

/** Chooses poses: the cause, each target alone at full and at half weight, and random combinations of up to four targets. */
function drawPoses(targets: readonly number[], cause: Pose): Pose[] {
  const rng = new Rng(1, 'poses')
  const poses: Pose[] = [cause]
  for (const target of targets) poses.push(new Map([[target, 1]]), new Map([[target, 0.5]]))
  while (poses.length < POSES) {
    const count = 2 + Math.floor(rng.next() * 3)
    const draw = () => [targets[Math.floor(rng.next() * targets.length)], rng.next()] as const
    poses.push(new Map(Array.from({ length: count }, draw)))
  }
  return poses
}

/** Returns the bounds of a target's weight. Targets of the other side, and targets that pull skin taut, get no positive weight. */
function boundsOf(name: string, shape: string, { cause, name: area }: SkinRegion): Bounds {
  const own = Object.keys(cause).find((known) => [known, `${known}Left`, `${known}Right`].includes(shape))
  // Targets of the cause get no negative weight.
  if (own !== undefined || name in cause) return [0, MAX_CAUSE * cause[own ?? name]]
  const isOpposite = /Left$/.test(area) ? /Right$/.test(shape) : /Right$/.test(area) && /Left$/.test(shape)
  return [MIN_WEIGHT, isOpposite || TAUT.test(shape) ? 0 : MAX_OTHER]
}

function percent(fraction: number): string {
  return `${(100 * fraction).toFixed(1)}%`
}

/** Rounds a weight to three decimals, to keep files short. */
export function roundWeight(weight: number): number {
  return Math.round(1000 * weight) / 1000
}

/** Returns the largest distance, in millimetres, by which a target of a pose moves skin. */
function largestMotion(offsets: readonly Float64Array[], pose: Pose): number {
  let most = 0
  for (const [target, weight] of pose) {
    const offset = offsets[target]
    for (let i = 0; i < offset.length; i += 3)
      most = Math.max(most, Math.abs(weight) * length3(offset[i], offset[i + 1], offset[i + 2]))
  }
  return most
}
