import { FaceTracker, type FaceTrackerOptions } from 'furrow/three'
import { blendMesh } from '../../test/blend-mesh.ts'
import { both, extremes, SHAPES, SimulatedTracker, type Truth } from './takes.ts'

/** Recordings that a person makes before the measurement. */
export type Calibrated = 'nothing' | 'neutral' | 'neutral and range'

/** Results of one person, or the worst of several. */
export interface Results {
  /** Lowest weight of the held sneer, where the truth is 1. */
  sneer: number
  /** Highest weight of any shape at rest. */
  neutral: number
  /** 95th percentile of the change per frame, of a smile held at 0.8. */
  jitter: number
  /** Time from the step of the truth to 90% of the held weight, milliseconds. */
  step: number
  /** Mean lag behind a ramp of one second, milliseconds. */
  ramp: number
  /** Amplitude of a sine of 1 Hz and 0.1, divided by the true amplitude. */
  sine: number
  /** Highest sneer while the upper lip moves as in speech. */
  speech: number
}

const SMILE = 'mouthSmileLeft'

/** Measures the weights that a tracker makes from the takes of one person. */
export function measurePerson(
  seed: number,
  calibrated: Calibrated,
  options: FaceTrackerOptions = {},
  fps = 30,
): Results {
  const face = blendMesh(...SHAPES)
  const tracker = new FaceTracker(face, options)
  const person = new SimulatedTracker(seed, fps)
  let now = 0
  /** Plays a take of a person, and returns truth and weight of a shape in each frame. */
  const play = (seconds: number, truthAt: (time: number) => Truth, shape = SMILE) => {
    const frames = [...person.frames(seconds, truthAt, now)].map(({ time, scores }) => {
      tracker.set(scores, time)
      const weights = face.morphTargetInfluences!
      return {
        time: time - now,
        truth: truthAt(time - now)[shape] ?? 0,
        weight: weights[face.morphTargetDictionary![shape]],
        highest: Math.max(...weights),
      }
    })
    now += seconds
    return frames
  }
  const rest = () => ({})
  if (calibrated !== 'nothing') {
    tracker.record('neutral')
    play(3, rest)
  }
  if (calibrated === 'neutral and range') {
    tracker.record('range')
    play(11, extremes)
    play(1, rest)
  }

  const neutral = Math.max(...play(5, rest).map(({ highest }) => highest))
  const sneer = settled(
    play(2, () => both('noseSneer', 1), 'noseSneerLeft'),
    0.5,
  )
  play(1, rest)
  const speech = play(3, (t) => both('mouthUpperUp', 0.25 + 0.25 * Math.sin(8 * t)), 'noseSneerLeft')
  play(1, rest)
  const step = play(2, () => both('mouthSmile', 1))
  // Settings without a calibrated range do not reach 1, so times are measured relative to the held weight.
  const held = mean(settled(step, 1))
  play(1, rest)
  const smile = settled(
    play(6, () => both('mouthSmile', 0.8)),
    1,
  )
  play(1, rest)
  const ramp = play(1, (t) => both('mouthSmile', t))
  play(1, rest)
  const wave = play(12, (t) => both('mouthSmile', 0.5 + 0.1 * Math.sin(2 * Math.PI * t)))
  return {
    sneer: Math.min(...sneer),
    neutral,
    jitter: percentile(
      smile.slice(1).map((weight, i) => Math.abs(weight - smile[i])),
      0.95,
    ),
    step: 1000 * (step.find(({ weight }) => weight >= 0.9 * held)?.time ?? Number.POSITIVE_INFINITY),
    ramp: 1000 * mean(ramp.map(({ truth, weight }) => truth - weight / held)),
    sine: amplitude(wave.filter(({ time }) => time >= 2)) / (0.1 * held),
    speech: Math.max(...speech.map(({ weight }) => weight)),
  }
}

/** Combines the results of several persons: the mean of the lag behind the ramp, which noise changes, and the worst of the others. */
export function combine(results: readonly Results[]): Results {
  const of = (name: keyof Results) => results.map((result) => result[name])
  return {
    sneer: Math.min(...of('sneer')),
    neutral: Math.max(...of('neutral')),
    jitter: Math.max(...of('jitter')),
    step: Math.max(...of('step')),
    ramp: mean(of('ramp')),
    sine: Math.min(...of('sine')),
    speech: Math.max(...of('speech')),
  }
}

interface Frame {
  time: number
  weight: number
}

/** Weights after the first seconds. */
function settled(frames: readonly Frame[], seconds: number): number[] {
  return frames.filter(({ time }) => time >= seconds).map(({ weight }) => weight)
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

function percentile(values: readonly number[], fraction: number): number {
  return values.toSorted((a, b) => a - b)[Math.floor(fraction * values.length)]
}

/** Amplitude of the part with 1 Hz, by correlation. */
function amplitude(frames: readonly Frame[]): number {
  const part = (wave: (angle: number) => number) =>
    mean(frames.map(({ time, weight }) => weight * wave(2 * Math.PI * time)))
  return 2 * Math.hypot(part(Math.sin), part(Math.cos))
}
