/** Parameters of the One Euro filter. */
export interface OneEuroOptions {
  /** Cutoff frequency for a still face, Hz. Lower values reduce jitter and lengthen the lag of slow motions. */
  minCutoff: number
  /** Increase of the cutoff frequency with speed, Hz per 1/s. Higher values shorten the lag of fast motions. */
  beta: number
  /** Cutoff frequency of the filter that smooths the speed, Hz. */
  speedCutoff: number
  /** Speed that counts as noise and does not increase the cutoff frequency, 1/s. 0 is the published filter. */
  noiseSpeed: number
}

/** Longest time between two frames for which the filter continues, seconds. After a longer pause it starts again. */
const MAX_PAUSE = 1

/**
 * One Euro filters of many signals with common times. Casiez, Roussel and Vogel, "1€ Filter", CHI 2012, algorithms 1 and 2
 * (https://doi.org/10.1145/2207676.2208639). `noiseSpeed` is an addition.
 */
export class OneEuroFilters {
  readonly #filtered: Float64Array
  readonly #speeds: Float64Array
  readonly #options: Readonly<OneEuroOptions>
  /** Time of the last frame, seconds; NaN before the first. */
  #time = Number.NaN

  /** @param count number of signals. */
  constructor(count: number, options: Readonly<OneEuroOptions>) {
    this.#filtered = new Float64Array(count)
    this.#speeds = new Float64Array(count)
    this.#options = options
  }

  /**
   * Replaces samples by their filtered values. The first samples are unchanged.
   *
   * @param samples one per signal.
   * @param time time of the samples, seconds. Samples at an earlier time or the same time get the last filtered values.
   */
  apply(samples: Float64Array, time: number): void {
    const { minCutoff, beta, speedCutoff, noiseSpeed } = this.#options
    const filtered = this.#filtered
    const seconds = time - this.#time
    if (Number.isNaN(seconds) || seconds > MAX_PAUSE) {
      filtered.set(samples)
      this.#speeds.fill(0)
      this.#time = time
      return
    }
    if (seconds > 0) {
      this.#time = time
      // Exponential smoothing with the cutoff frequency c gives a new sample the weight 1 / (1 + 1 / (2 pi c seconds)). The formula is inline,
      // because a function would allocate numbers.
      const turn = 2 * Math.PI * seconds
      const share = 1 / (1 + 1 / (turn * speedCutoff))
      for (let i = 0; i < filtered.length; i++) {
        const speed = (samples[i] - filtered[i]) / seconds
        this.#speeds[i] += share * (speed - this.#speeds[i])
        const cutoff = minCutoff + beta * Math.max(0, Math.abs(this.#speeds[i]) - noiseSpeed)
        filtered[i] += (samples[i] - filtered[i]) / (1 + 1 / (turn * cutoff))
      }
    }
    samples.set(filtered)
  }
}
