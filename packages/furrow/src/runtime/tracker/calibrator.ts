import type { FaceCalibration, ShapeCalibration } from './calibration.ts'

/** Subject of a recording: the neutral face, or the extremes of all expressions. */
export type RecordingKind = 'neutral' | 'range'

/** Defaults for shapes without calibration. */
const UNCALIBRATED: ShapeCalibration = { neutral: 0, noise: 0, extreme: 1 }

/** Smallest difference between neutral and extreme scores that counts as a signal. */
const MIN_RANGE = 0.03

/** Smallest ratio of this difference to the noise. */
const MIN_SIGNAL = 8

/** Time constant of the average whose maximum is the extreme, seconds. A single wrong frame changes the average little. */
const EXTREME_SECONDS = 0.1

/** Lowest calibrated score. Lower scores would delay the next expression. */
const LOWEST = -0.1

/** Learns neutral and extreme scores of blendshapes, and scales scores such that neutral is 0 and extreme is 1. */
export class Calibrator {
  readonly #shapes: readonly string[]
  readonly #neutral: Float64Array
  readonly #noise: Float64Array
  readonly #extreme: Float64Array
  /** Scores averaged over `EXTREME_SECONDS`. */
  readonly #average: Float64Array
  /** Highest average since the recording began, or since the first frame. */
  readonly #peak: Float64Array
  /** Noise of the shapes at rest, as a fraction of their ranges. */
  readonly noise: Float64Array
  /** Highest calibrated scores of the shapes so far. */
  readonly reach: Float64Array
  readonly #sum: Float64Array
  readonly #sumOfSquares: Float64Array
  #frames = 0
  #time = Number.NaN

  constructor(shapes: readonly string[], known: FaceCalibration) {
    this.#shapes = shapes
    const values = (field: keyof ShapeCalibration) =>
      Float64Array.from(shapes, (name) => (known.shapes[name] ?? UNCALIBRATED)[field])
    this.#neutral = values('neutral')
    this.#noise = values('noise')
    this.#extreme = values('extreme')
    this.#average = new Float64Array(shapes.length)
    this.#peak = new Float64Array(shapes.length).fill(Number.NEGATIVE_INFINITY)
    this.noise = new Float64Array(shapes.length)
    this.reach = new Float64Array(shapes.length)
    this.#sum = new Float64Array(shapes.length)
    this.#sumOfSquares = new Float64Array(shapes.length)
  }

  /** Begins a recording. */
  begin(): void {
    this.#frames = 0
    this.#time = Number.NaN
    this.#sum.fill(0)
    this.#sumOfSquares.fill(0)
    this.#peak.fill(Number.NEGATIVE_INFINITY)
  }

  /** Learns from the scores of a frame. `time` is in seconds. */
  observe(scores: Float64Array, time: number): void {
    const share = Number.isNaN(this.#time)
      ? 1
      : 1 - Math.exp(Math.min(0, this.#time - time) / EXTREME_SECONDS)
    this.#time = time
    this.#frames++
    for (let i = 0; i < scores.length; i++) {
      this.#sum[i] += scores[i]
      this.#sumOfSquares[i] += scores[i] * scores[i]
      this.#average[i] += share * (scores[i] - this.#average[i])
      this.#peak[i] = Math.max(this.#peak[i], this.#average[i])
      this.#extreme[i] = Math.max(this.#extreme[i], this.#average[i])
    }
  }

  /** Ends a recording, and stores what it measured. */
  finish(kind: RecordingKind): void {
    for (let i = 0; i < this.#shapes.length; i++) {
      if (kind === 'neutral') {
        const mean = this.#sum[i] / this.#frames
        this.#neutral[i] = mean
        this.#noise[i] = Math.sqrt(Math.max(0, this.#sumOfSquares[i] / this.#frames - mean * mean))
        if (!this.#isSignal(i, this.#extreme[i])) this.#extreme[i] = mean + 1
      } else if (this.#isSignal(i, this.#peak[i])) this.#extreme[i] = this.#peak[i]
    }
  }

  /** Scales scores in place, and updates `noise` and `reach`. */
  apply(scores: Float64Array): void {
    for (let i = 0; i < scores.length; i++) {
      const neutral = this.#neutral[i]
      const extent = this.#extreme[i] - neutral
      scores[i] = Math.min(1, Math.max(LOWEST, (scores[i] - neutral) / extent))
      this.noise[i] = this.#noise[i] / extent
      this.reach[i] = Math.max(0, (this.#peak[i] - neutral) / extent)
    }
  }

  /** Calibrations of all shapes, and of the shapes in `others` that this source does not deliver. */
  documentWith(others: FaceCalibration): FaceCalibration {
    const shapes = Object.fromEntries(
      this.#shapes.map((name, i) => [
        name,
        { neutral: this.#neutral[i], noise: this.#noise[i], extreme: this.#extreme[i] },
      ]),
    )
    return { version: 1, shapes: { ...others.shapes, ...shapes } }
  }

  #isSignal(index: number, score: number): boolean {
    return score - this.#neutral[index] >= Math.max(MIN_RANGE, MIN_SIGNAL * this.#noise[index])
  }
}
