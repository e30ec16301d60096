import { checkFinite, isObject, wrongArgument } from '../../core/argument.ts'
import { formatProblem } from '../../core/error.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'
import type { BindTargets } from '../target-binding.ts'
import { type FaceCalibration, parseCalibration } from './calibration.ts'
import { Calibrator, type RecordingKind } from './calibrator.ts'
import { OneEuroFilters } from './one-euro.ts'
import { type FaceTrackerOptions, type TrackerSettings, trackerSettings } from './options.ts'
import { planTracker, type TrackerPlan } from './plan.ts'

/** Score of one blendshape, as in the results of MediaPipe's face landmarker. */
export interface FaceScore {
  /** Name of the blendshape. */
  categoryName: string
  /** Weight of the blendshape, 0..1. */
  score: number
}

/** Scores of one frame: MediaPipe's list, or an object with a score per name. */
export type FrameScores = readonly FaceScore[] | Readonly<Record<string, number>>

const WHO = 'FaceTracker'

/** Default durations of recordings, seconds. */
const SECONDS: Readonly<Record<RecordingKind, number>> = { neutral: 2, range: 10 }

/** Width of the dead zone as a multiple of the noise. The default filter lets a quarter of the noise through. */
const NOISE_WIDTH = 1.2

/** Multiple of the dead zone above which weights are unchanged. Between, weights increase faster, so that no weight jumps. */
const ZONE_END = 3

/** Widest dead zone that noise causes. */
const MAX_NOISE_ZONE = 0.25

/** Number of unknown names after which no more warnings are logged, so that a faulty source cannot fill the memory. */
const MAX_WARNED = 512

interface Recording {
  kind: RecordingKind
  seconds: number
  /** Time of the first frame, seconds; undefined before it. */
  start: number | undefined
}

/** Turns the scores of a face tracker into blendshape weights of a face. Base class for `FaceTracker` of each engine. */
export class FaceTrackerBase {
  readonly #bind: BindTargets
  readonly #settings: TrackerSettings
  #isMirrored: boolean
  #recording: Recording | null = null
  /** Calibration that was loaded, or that the last list of names had. */
  #known: FaceCalibration = { version: 1, shapes: {} }

  #names: string[] = []
  #plan: TrackerPlan = { shapes: [], links: [], substitutes: [], bindings: [], missing: [] }
  #scores = new Float64Array(0)
  #weights = new Float64Array(0)
  #gains = new Float64Array(0)
  #calibrator = new Calibrator([], this.#known)
  #filters: OneEuroFilters | null = null
  /** Names of scores about which a warning was logged. */
  readonly #warned = new Set<string>()

  /**
   * @param bind finds blendshapes on the meshes of the face.
   * @throws FurrowError for an unknown or invalid option.
   */
  constructor(bind: BindTargets, options: FaceTrackerOptions) {
    this.#bind = bind
    this.#settings = trackerSettings(options, WHO)
    this.#isMirrored = this.#settings.mirror
  }

  /**
   * Sets the weights of the blendshapes that the scores name. Other scores, such as `_neutral`, are ignored. Names that the
   * face lacks are skipped with one warning. NaN counts as 0. A list allocates nothing while its names and their order stay the same.
   *
   * @param scores scores of one frame. Names may be those of MediaPipe, ARKit, Live Link Face, iFacialMocap, VMC, VRM, OpenSeeFace, or
   *   Oculus visemes, in any spelling that `findTargets` of `furrow` knows.
   * @param seconds time of the frame, seconds. Default: the current time.
   * @throws FurrowError if no mesh of the face has morph targets, `scores` is neither a list nor an object, or `seconds` is not finite.
   */
  set(scores: FrameScores, seconds: number = performance.now() / 1000): void {
    if (!isObject(scores)) throw wrongArgument(WHO, 'scores', scores, 'a list or an object')
    checkFinite(seconds, 'seconds', WHO)
    if (!this.#read(scores)) {
      this.#connect(scores)
      this.#read(scores)
    }
    const weights = this.#weights
    this.#addScores()
    this.#calibrator.observe(weights, seconds)
    this.#updateRecording(seconds)
    this.#calibrator.apply(weights)
    for (let i = 0; i < weights.length; i++) weights[i] = Math.min(1, weights[i] * this.#gains[i])
    this.#filters?.apply(weights, seconds)
    this.#applyDeadZones()
    this.#addSubstitutes()
    const { bindings } = this.#plan
    for (let i = 0; i < bindings.length; i++) {
      const { influences, target, name } = bindings[i]
      influences[target] = weights[name]
    }
  }

  /** Whether the person's left side moves the right side of the face. */
  get mirror(): boolean {
    return this.#isMirrored
  }

  set mirror(isMirrored: boolean) {
    if (typeof isMirrored !== 'boolean') throw wrongArgument(WHO, 'mirror', isMirrored, 'true or false')
    if (isMirrored === this.#isMirrored) return
    this.#isMirrored = isMirrored
    for (const { influences, target } of this.#plan.bindings) influences[target] = 0
    this.#names = []
  }

  /**
   * Starts a recording with the next scores. `neutral` learns the scores and the noise of a relaxed face. `range` learns the highest score of
   * each blendshape, while the person smiles, frowns, sneers and so on as strongly as possible. A running recording is discarded.
   *
   * @param seconds duration. Default: 2 for `neutral`, 10 for `range`.
   * @throws FurrowError for another kind, or a duration that is not above 0.
   */
  record(kind: RecordingKind, seconds: number = SECONDS[kind]): void {
    if (!Object.hasOwn(SECONDS, kind)) throw wrongArgument(WHO, 'kind', kind, 'neutral or range')
    if (!(Number.isFinite(seconds) && seconds > 0)) {
      throw wrongArgument(WHO, 'seconds', seconds, 'a number above 0')
    }
    this.#recording = { kind, seconds, start: undefined }
  }

  /** Kind of the recording that runs; null if none does. */
  get recording(): RecordingKind | null {
    return this.#recording?.kind ?? null
  }

  /** Calibration as plain data for `JSON.stringify`. Setting it checks the data. */
  get calibration(): FaceCalibration {
    return this.#calibrator.documentWith(this.#known)
  }

  /** @throws FurrowError if the value is not a valid calibration. The previous calibration then stays. */
  set calibration(value: FaceCalibration) {
    this.#known = parseCalibration(value, WHO)
    this.#calibrator = new Calibrator(this.#plan.shapes, this.#known)
    this.#recording = null
  }

  /** Reads scores. Returns false if the names are not those of the frame before. */
  #read(scores: FrameScores): boolean {
    const names = this.#names
    if (Array.isArray(scores)) {
      if (scores.length !== names.length) return false
      for (let i = 0; i < names.length; i++) {
        if (scores[i]?.categoryName !== names[i]) return false
        this.#scores[i] = numberOf(scores[i].score)
      }
      return true
    }
    let count = 0
    for (const name in scores) {
      if (name !== names[count]) return false
      this.#scores[count++] = numberOf((scores as Record<string, number>)[name])
    }
    return count === names.length
  }

  #connect(scores: FrameScores): void {
    const names = Array.isArray(scores) ? scores.map(nameOf) : Object.keys(scores)
    const { substitutes, gains, filter } = this.#settings
    const plan = planTracker(names, this.#bind, {
      isMirrored: this.#isMirrored,
      hasSubstitutes: substitutes,
    })
    this.#known = this.calibration
    this.#names = names
    this.#plan = plan
    this.#scores = new Float64Array(names.length)
    this.#weights = new Float64Array(plan.shapes.length)
    const gainOf = new Map(Object.entries(gains).map(([name, gain]) => [canonicalTargetName(name), gain]))
    this.#gains = Float64Array.from(plan.shapes, (shape) => gainOf.get(shape) ?? 1)
    this.#calibrator = new Calibrator(plan.shapes, this.#known)
    this.#filters = filter && new OneEuroFilters(plan.shapes.length, filter)
    if (this.#recording) this.#recording.start = undefined
    this.#warn(plan.missing)
  }

  #warn(missing: readonly string[]): void {
    const names = missing.filter((name) => !this.#warned.has(name))
    if (names.length === 0 || this.#warned.size > MAX_WARNED) return
    for (const name of names) this.#warned.add(name)
    console.warn(
      formatProblem({
        who: WHO,
        problem: 'the face lacks blendshapes of the scores',
        value: names.join(', '),
        remedy: 'the other blendshapes are set',
      }),
    )
  }

  #addScores(): void {
    this.#weights.fill(0)
    const { links } = this.#plan
    for (let i = 0; i < links.length; i++) {
      const { score, shape, up, down } = links[i]
      const value = this.#scores[score]
      this.#weights[shape] += value > 0 ? up * value : -down * value
    }
  }

  #updateRecording(seconds: number): void {
    const recording = this.#recording
    if (!recording) return
    if (recording.start === undefined) {
      recording.start = seconds
      this.#calibrator.begin()
      this.#calibrator.observe(this.#weights, seconds)
    } else if (seconds - recording.start >= recording.seconds) {
      this.#calibrator.finish(recording.kind)
      this.#recording = null
    }
  }

  #applyDeadZones(): void {
    const { filter, deadZone } = this.#settings
    const weights = this.#weights
    const { noise } = this.#calibrator
    for (let i = 0; i < weights.length; i++) {
      const zone = Math.max(deadZone, filter ? Math.min(MAX_NOISE_ZONE, NOISE_WIDTH * noise[i]) : 0)
      if (weights[i] <= zone) weights[i] = 0
      else if (weights[i] < zone * ZONE_END) weights[i] = ((weights[i] - zone) * ZONE_END) / (ZONE_END - 1)
    }
  }

  #addSubstitutes(): void {
    const weights = this.#weights
    const { substitutes } = this.#plan
    const { reach } = this.#calibrator
    for (let i = 0; i < substitutes.length; i++) substitutes[i].apply(weights, reach)
  }
}

/** Reads a score. Invalid scores are 0, and scores out of range are clamped. */
function numberOf(score: unknown): number {
  return Math.min(1, Math.max(-1, Number(score) || 0))
}

function nameOf(score: FaceScore): string {
  if (typeof score?.categoryName === 'string') return score.categoryName
  throw wrongArgument(WHO, 'score', score, 'an object with categoryName and score')
}
