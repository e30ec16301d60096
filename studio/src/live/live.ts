import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { FaceCalibration, FrameScores, RecordingKind } from 'furrow/three'
import type { TakeMotion } from '../document/take.ts'
import type { LivePose } from '../viewer/pose/live-pose.ts'
import { storeCalibration, storedCalibration } from './calibrations.ts'
import type { SourceCode } from './load-source.ts'
import { type LiveSettings, readSettings, type SourceName, storeSettings } from './settings.ts'
import type { RunningSource, SourceEvents, SourceStatus } from './source.ts'
import { MAX_SECONDS, TakeRecorder } from './take-recorder.ts'

/** Durations of calibrations, seconds. */
const CALIBRATION: Readonly<Record<RecordingKind, number>> = { neutral: 2, range: 10 }

export interface LiveParts {
  pose: Pick<
    LivePose,
    | 'isOn'
    | 'begin'
    | 'options'
    | 'set'
    | 'record'
    | 'recording'
    | 'calibration'
    | 'calibrate'
    | 'weights'
    | 'stop'
  >
  /** Loads the code of a source. */
  load(source: SourceName): Promise<SourceCode>
  /** Resolves when a take can be kept. Rejects with a FurrowError if it cannot. */
  ready(): Promise<void>
  onTake(motion: TakeMotion): void
  /** Called when a take has reached its maximum length. */
  onFull(): void
  onError(error: unknown): void
}

/** Calibration that runs. */
export interface Calibrating {
  readonly kind: RecordingKind
  /** Remaining time, whole seconds. */
  readonly left: number
}

/** Follows a source of live face scores: connects, calibrates, and records takes. */
export class Live {
  readonly #parts: LiveParts
  readonly #settings = signal(readSettings())
  readonly #status = signal<SourceStatus | null>(null)
  readonly #sender = signal<string | null>(null)
  readonly #calibrating = signal<Calibrating | null>(null)
  readonly #isCalibrated = signal(false)
  readonly #recorded = signal<number | null>(null)
  readonly #isPreparing = signal(false)
  /** Changes with each start and stop, so that events of an old source are ignored. */
  #run = 0
  #source: RunningSource | null = null
  #calibrationStart: number | null = null
  #recorder: TakeRecorder | null = null

  constructor(parts: LiveParts) {
    this.#parts = parts
    // Other motion, such as an expression, ends the live pose.
    effect(() => {
      if (!parts.pose.isOn.value) this.stop()
    })
  }

  get settings(): ReadonlySignal<LiveSettings> {
    return this.#settings
  }

  /** State of the source, or null while none runs. */
  get status(): ReadonlySignal<SourceStatus | null> {
    return this.#status
  }

  /** Sender of the last scores, such as `webcam` or `vmc`. Null before the first scores. */
  get sender(): ReadonlySignal<string | null> {
    return this.#sender
  }

  get calibrating(): ReadonlySignal<Calibrating | null> {
    return this.#calibrating
  }

  /** Whether the sender has a stored calibration. */
  get isCalibrated(): ReadonlySignal<boolean> {
    return this.#isCalibrated
  }

  /** Duration of the take that is being recorded, whole seconds. Null while none is. */
  get recorded(): ReadonlySignal<number | null> {
    return this.#recorded
  }

  /** Whether a recording begins soon, when takes can be kept. */
  get isPreparing(): ReadonlySignal<boolean> {
    return this.#isPreparing
  }

  /** Changes settings. Those of the source have an effect at the next start. */
  change(settings: Partial<LiveSettings>): void {
    this.#settings.value = { ...this.#settings.peek(), ...settings }
    storeSettings(this.#settings.peek())
    const { mirror, isSmooth } = this.#settings.peek()
    if (this.#parts.pose.isOn.peek()) this.#parts.pose.options = { mirror, isSmooth }
  }

  /** Starts the chosen source. Rejects with a FurrowError if that fails. */
  async start(): Promise<void> {
    this.stop()
    const run = this.#run
    const settings = this.#settings.peek()
    this.#status.value = 'starting'
    try {
      const { start, Tracker } = await this.#parts.load(settings.source)
      if (run !== this.#run) return
      this.#parts.pose.begin(settings, Tracker)
      const source = await start(settings, this.#eventsOf(run))
      if (run === this.#run) this.#source = source
      else source.stop()
    } catch (error) {
      if (run !== this.#run) return
      this.stop()
      throw error
    }
  }

  /** Stops the source, and restores the pose that the face had before. Keeps what was recorded. */
  stop(): void {
    if (this.#status.peek() === null) return
    this.#run++
    this.#source?.stop()
    this.#source = null
    this.#status.value = this.#sender.value = this.#calibrating.value = null
    this.#isCalibrated.value = false
    this.#parts.pose.stop()
    this.#finish()
  }

  /** Learns the neutral face, or the strongest expressions, from the next scores. */
  calibrate(kind: RecordingKind): void {
    if (this.#sender.peek() === null) return
    this.#parts.pose.record(kind)
    this.#calibrationStart = null
    this.#calibrating.value = { kind, left: CALIBRATION[kind] }
  }

  /** Uses a calibration from a file. Null forgets the calibration. Throws FurrowError if it is invalid. */
  setCalibration(calibration: FaceCalibration | null): void {
    const sender = this.#sender.peek()
    if (sender === null) return
    this.#calibrating.value = null
    this.#parts.pose.calibrate(calibration ?? { version: 1, shapes: {} })
    storeCalibration(sender, calibration)
    this.#isCalibrated.value = calibration !== null
  }

  get calibration(): FaceCalibration | null {
    return this.#parts.pose.calibration
  }

  /** Starts to record a take, or finishes it. Rejects with a FurrowError if takes cannot be kept. */
  async toggleRecording(): Promise<void> {
    if (this.#recorder) {
      this.#finish()
      return
    }
    if (this.#sender.peek() === null || this.#isPreparing.peek()) return
    const run = this.#run
    this.#isPreparing.value = true
    try {
      // Wait before the recording, because a take that cannot be kept would be lost.
      await this.#parts.ready()
    } finally {
      this.#isPreparing.value = false
    }
    if (run !== this.#run) return
    this.#recorder = new TakeRecorder()
    this.#recorded.value = 0
  }

  #eventsOf(run: number): SourceEvents {
    const isOld = () => run !== this.#run
    return {
      onScores: (scores, seconds, sender) => {
        if (!isOld()) this.#follow(scores, seconds, sender)
      },
      onStatus: (status) => {
        if (!isOld()) this.#status.value = status
      },
      onError: (error) => {
        if (isOld()) return
        this.stop()
        this.#parts.onError(error)
      },
    }
  }

  #follow(scores: FrameScores, seconds: number, sender: string): void {
    this.#status.value = 'connected'
    if (sender !== this.#sender.peek()) this.#meet(sender)
    const { pose } = this.#parts
    if (!pose.set(scores, seconds)) return
    this.#countDown(seconds)
    const recorder = this.#recorder
    if (!recorder) return
    recorder.add(seconds, pose.weights())
    this.#recorded.value = Math.floor(recorder.seconds)
    if (recorder.seconds < MAX_SECONDS) return
    this.#finish()
    this.#parts.onFull()
  }

  /** Uses the stored calibration of a new sender. */
  #meet(sender: string): void {
    this.#sender.value = sender
    this.#calibrating.value = null
    const stored = storedCalibration(sender)
    try {
      this.#parts.pose.calibrate(stored ?? { version: 1, shapes: {} })
      this.#isCalibrated.value = stored !== null
    } catch {
      // The stored data is damaged. Calibrating again replaces it.
      storeCalibration(sender, null)
      this.#isCalibrated.value = false
    }
  }

  #countDown(seconds: number): void {
    const calibrating = this.#calibrating.peek()
    if (!calibrating) return
    const { kind } = calibrating
    const { pose } = this.#parts
    this.#calibrationStart ??= seconds
    if (pose.recording === kind) {
      const left = Math.max(1, Math.ceil(CALIBRATION[kind] - (seconds - this.#calibrationStart)))
      if (left !== calibrating.left) this.#calibrating.value = { kind, left }
      return
    }
    this.#calibrating.value = null
    storeCalibration(this.#sender.peek()!, pose.calibration)
    this.#isCalibrated.value = true
  }

  #finish(): void {
    const recorder = this.#recorder
    if (!recorder) return
    this.#recorder = null
    this.#recorded.value = null
    try {
      this.#parts.onTake(recorder.finish())
    } catch (error) {
      this.#parts.onError(error)
    }
  }
}
