import { seeded } from '../../test/random.ts'

/** Weights of blendshapes that a simulated person shows, 0..1. Missing shapes are 0. */
export type Truth = Readonly<Record<string, number>>

/** Shapes that the simulated tracker delivers, in its order. */
export const SHAPES = [
  'browDown',
  'browOuterUp',
  'cheekSquint',
  'eyeBlink',
  'eyeSquint',
  'eyeWide',
  'mouthFrown',
  'mouthSmile',
  'mouthUpperUp',
  'noseSneer',
].flatMap((name) => [`${name}Left`, `${name}Right`])

/** Scores that MediaPipe keeps below 0.05 (https://github.com/google-ai-edge/mediapipe/issues/4450). */
const WEAK = /^(noseSneer|cheekSquint)/

/** Standard deviation of the noise at weight 0, and its increase up to weight 1. At weight 0.8, 95% of frames differ by less than 0.15. */
const NOISE = [0.015, 0.049] as const

/** A frame of the simulated tracker. */
export interface Take {
  /** Time in seconds. */
  time: number
  /** Scores in the format of MediaPipe. */
  scores: { categoryName: string; score: number }[]
}

/** Simulates a face tracker with the faults of MediaPipe: biased neutral, reduced range, weak sneers, noise, and irregular frame times. */
export class SimulatedTracker {
  readonly #random: () => number
  readonly #shapes: { name: string; neutral: number; extreme: number }[]
  readonly #lip: number
  readonly #brow: number
  readonly #fps: number

  /** @param seed number of the person. The same seed gives the same person and noise. */
  constructor(seed: number, fps = 30) {
    const random = seeded(seed)
    const between = (low: number, high: number) => low + (high - low) * random()
    this.#random = random
    this.#fps = fps
    this.#shapes = SHAPES.map((name) => {
      const neutral = WEAK.test(name) ? 0 : between(0, name.startsWith('browDown') ? 0.3 : 0.08)
      return { name, neutral, extreme: WEAK.test(name) ? between(0.005, 0.03) : between(0.6, 0.95) }
    })
    this.#lip = between(0.4, 0.7)
    this.#brow = between(0.35, 0.65)
  }

  /** Simulates the frames from time 0 to `seconds`, offset by `start`. */
  *frames(seconds: number, truthAt: (time: number) => Truth, start = 0): Generator<Take> {
    const phase = this.#random()
    for (let i = 0; i < seconds * this.#fps; i++) {
      const time = (i + phase + 0.2 * (this.#random() - 0.5)) / this.#fps
      yield { time: start + time, scores: this.#scoresOf(truthAt(time)) }
    }
  }

  #scoresOf(truth: Truth): Take['scores'] {
    return this.#shapes.map(({ name, neutral, extreme }) => {
      // A sneer also moves the upper lip and the brow.
      const side = name.endsWith('Left') ? 'Left' : 'Right'
      const sneer = truth[`noseSneer${side}`] ?? 0
      const coupled = name.startsWith('mouthUpperUp')
        ? this.#lip
        : name.startsWith('browDown')
          ? this.#brow
          : 0
      const weight = Math.max(truth[name] ?? 0, coupled * sneer)
      const noise = (NOISE[0] + NOISE[1] * weight) * this.#normal() * (extreme - neutral)
      const score = neutral + (extreme - neutral) * weight + noise
      return { categoryName: name, score: Math.min(1, Math.max(0, score)) }
    })
  }

  /** A random number of the standard normal distribution (Box and Muller 1958). */
  #normal(): number {
    return Math.sqrt(-2 * Math.log(1 - this.#random())) * Math.cos(2 * Math.PI * this.#random())
  }
}

export const both = (name: string, weight: number): Truth => ({
  [`${name}Left`]: weight,
  [`${name}Right`]: weight,
})

/** Shows each shape for a second, one after another, as a person does who calibrates the range. */
export function extremes(time: number): Truth {
  const name = SHAPES[2 * Math.floor(time)]?.replace('Left', '') ?? ''
  return both(name, Math.min(1, Math.max(0, 2.5 * Math.sin(Math.PI * (time % 1)) - 0.5)))
}
