import { FurrowError } from 'furrow'

/** Key frames of a take per second. */
export const TAKE_RATE = 60
/** Maximum number of key frames (over half an hour), of takes, and of blendshapes in a take. */
export const MAX_FRAMES = 120_000
export const MAX_TAKES = 256
export const MAX_TAKE_SHAPES = 1024
/** Weights are rounded to a multiple of 1 / `STEPS`, so that text files restore them exactly. */
const STEPS = 1e5
/** Distance from a sample, as a fraction of the interval, that counts as 0. Captures have 32-bit times, which are inexact. */
const SNAP = 0.01

/** Weights of blendshapes over time. Never changed in place. */
export interface TakeMotion {
  /** Names of blendshapes in any spelling that drivers accept. */
  readonly names: readonly string[]
  /** Weights, 0..1: all key frames of the first blendshape, then those of the second, and so on. At least two key frames each. */
  readonly weights: Float32Array
}

/** Recorded performance of a face. */
export interface Take {
  readonly name: string
  readonly motion: TakeMotion
  /** In and out points, seconds. Default: the whole take. */
  readonly range?: readonly [number, number]
}

/** Number of key frames. */
export function framesOf({ names, weights }: TakeMotion): number {
  return weights.length / names.length
}

/** Duration of all key frames, seconds. */
export function durationOf(motion: TakeMotion): number {
  return (framesOf(motion) - 1) / TAKE_RATE
}

/** In and out points, seconds. */
export function rangeOf({ motion, range = [0, durationOf(motion)] }: Take): readonly [number, number] {
  return range
}

/** Returns the key frames of the blendshape with an index, as a view. */
export function weightsOf(motion: TakeMotion, index: number): Float32Array {
  const frames = framesOf(motion)
  return motion.weights.subarray(index * frames, (index + 1) * frames)
}

/** Returns the key frames between the in and out points as a new motion. */
export function trimmed(take: Take): TakeMotion {
  const { motion } = take
  const [start, end] = rangeOf(take)
  const times = Float64Array.of(start, end)
  if (start === 0 && end === durationOf(motion)) return motion
  const all = Float64Array.from({ length: framesOf(motion) }, (_, i) => i / TAKE_RATE)
  const columns = motion.names.map((name, i) => [name, weightsOf(motion, i)] as const)
  return { names: motion.names, weights: sampled(times, all, columns) }
}

/**
 * Makes a motion by linear interpolation between samples. Omits blendshapes that stay at 0.
 *
 * @param times times of the samples, seconds, strictly increasing.
 * @param columns names of blendshapes with their weights at `times`.
 * @throws FurrowError if there are fewer than two samples, or too many key frames.
 */
export function motionOf(
  times: ArrayLike<number>,
  columns: Iterable<readonly [name: string, weights: ArrayLike<number>]>,
): TakeMotion {
  if (times.length < 2) throw takeError('the take has no motion', times.length, '2 frames or more')
  const all = [...columns]
  const moving = all.filter(([, weights]) => Array.prototype.some.call(weights, (weight) => weight !== 0))
  const kept = moving.length > 0 ? moving : all.slice(0, 1)
  const range = Float64Array.of(times[0], times[times.length - 1])
  return { names: kept.map(([name]) => name), weights: sampled(range, times, kept) }
}

/** Samples all columns at `TAKE_RATE` between two times. */
function sampled(
  [start, end]: Float64Array,
  times: ArrayLike<number>,
  columns: readonly (readonly [name: string, weights: ArrayLike<number>])[],
): Float32Array {
  // Tolerate rounding of times, so that no key frame is lost at the end.
  const frames = Math.max(2, Math.floor((end - start) * TAKE_RATE + 1.001))
  if (frames > MAX_FRAMES) throw takeError('the take is too long', frames, `${MAX_FRAMES} key frames`)
  const result = new Float32Array(frames * columns.length)
  let next = 1
  for (let frame = 0; frame < frames; frame++) {
    const time = Math.min(start + frame / TAKE_RATE, end)
    while (next < times.length - 1 && times[next] < time) next++
    const span = times[next] - times[next - 1]
    const share = Math.min(1, Math.max(0, (time - times[next - 1]) / span))
    const t = Math.abs(share - Math.round(share)) < SNAP ? Math.round(share) : share
    for (const [i, [, weights]] of columns.entries()) {
      const weight = weights[next - 1] * (1 - t) + weights[next] * t
      result[i * frames + frame] = Math.round(Math.min(1, Math.max(0, weight)) * STEPS) / STEPS
    }
  }
  return result
}

function takeError(problem: string, value: number, limit: string): FurrowError {
  return new FurrowError({ who: 'Studio', problem, value, limit, remedy: 'record it again' })
}
