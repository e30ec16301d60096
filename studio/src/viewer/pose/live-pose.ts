import { type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError } from 'furrow'
import type { FaceCalibration, FaceTracker, FrameScores, RecordingKind } from 'furrow/three'
import type { Viewer } from '../viewer.ts'
import { type Pose, poseOf, writePose } from './pose.ts'

export interface LivePoseParts {
  viewer: ReadonlySignal<Pick<Viewer, 'avatar' | 'targets' | 'areas' | 'skeleton' | 'move'> | null>
  /** Called before scores move the face, to stop other motion. */
  begin(): void
  /** Whether something else determines the pose now. Scores then have no effect. */
  isHeld(): boolean
  /** Called after the pose changed, so that a frame is drawn. */
  onPose(): void
}

export interface TrackerOptions {
  mirror: boolean
  /** Whether to remove jitter. */
  isSmooth: boolean
}

/** Moves the blendshapes of the shown face by the scores of a camera, a phone or a voice. */
export class LivePose {
  readonly #parts: LivePoseParts
  readonly #isOn = signal(false)
  #tracker: FaceTracker | null = null
  #Tracker: typeof FaceTracker | null = null
  #options: TrackerOptions = { mirror: true, isSmooth: true }
  /** Blendshapes for which the tracker was made. Muscles add and remove blendshapes. */
  #targets: Viewer['targets'] = []
  #before: { root: unknown; pose: Pose } | null = null

  constructor(parts: LivePoseParts) {
    this.#parts = parts
  }

  /** Whether scores determine the pose. */
  get isOn(): ReadonlySignal<boolean> {
    return this.#isOn
  }

  /**
   * Remembers the pose, and relaxes the face.
   *
   * @param Tracker class of the tracker, which the page loads when it is needed.
   * @throws FurrowError if no face is shown, or the face has no blendshapes.
   */
  begin(options: TrackerOptions, Tracker: typeof FaceTracker): void {
    const viewer = this.#parts.viewer.peek()
    if (!viewer || viewer.targets.length === 0) throw noBlendshapesError()
    this.#parts.begin()
    this.#options = options
    this.#Tracker = Tracker
    this.#before = { root: viewer.avatar.root, pose: poseOf(viewer) }
    viewer.move(() => {
      for (const dial of viewer.targets) dial.write(0)
    })
    this.#tracker = null
    this.#isOn.value = true
    this.#parts.onPose()
  }

  /** Changes options, and keeps the calibration. */
  set options(options: TrackerOptions) {
    this.#options = options
    this.#targets = []
  }

  /** Sets the pose by the scores of a frame. @param seconds time of the frame. @returns whether the face moved. */
  set(scores: FrameScores, seconds: number): boolean {
    const viewer = this.#parts.viewer.peek()
    if (!this.#isOn.peek() || !viewer || this.#parts.isHeld()) return false
    const tracker = this.#trackerOf(viewer)
    viewer.move(() => tracker.set(scores, seconds))
    this.#parts.onPose()
    return true
  }

  /** Starts to calibrate; see `FaceTracker.record`. */
  record(kind: RecordingKind): void {
    this.#tracker?.record(kind)
  }

  /** Running calibration, or null. */
  get recording(): RecordingKind | null {
    return this.#tracker?.recording ?? null
  }

  /** Calibration of the person. Null before the first scores. */
  get calibration(): FaceCalibration | null {
    return this.#tracker?.calibration ?? null
  }

  /** @throws FurrowError if the calibration is invalid. */
  calibrate(calibration: FaceCalibration): void {
    const viewer = this.#parts.viewer.peek()
    if (viewer && this.#isOn.peek()) this.#trackerOf(viewer).calibration = calibration
  }

  /** Weights of all blendshapes of the face now. The keys are their names. */
  weights(): Map<string, number> {
    return new Map(this.#parts.viewer.peek()?.targets.map(({ name, read }) => [name, read()]))
  }

  /** Restores the pose that the face had before `begin`. */
  stop(): void {
    if (!this.#isOn.peek()) return
    this.#isOn.value = false
    const [viewer, before] = [this.#parts.viewer.peek(), this.#before]
    this.#before = this.#tracker = null
    if (!viewer || viewer.avatar.root !== before?.root) return
    viewer.move(() => writePose(viewer, before.pose))
    this.#parts.onPose()
  }

  #trackerOf({ avatar, targets }: Pick<Viewer, 'avatar' | 'targets'>): FaceTracker {
    const old = this.#tracker
    if (old && targets === this.#targets) return old
    const { mirror, isSmooth } = this.#options
    for (const dial of targets) dial.write(0)
    const tracker = new this.#Tracker!(avatar.root, {
      mirror,
      substitutes: true,
      ...(!isSmooth && { filter: null }),
    })
    if (old) tracker.calibration = old.calibration
    if (old?.recording) tracker.record(old.recording)
    this.#tracker = tracker
    this.#targets = targets
    return tracker
  }
}

function noBlendshapesError(): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'there is no face with blendshapes that a camera, a phone or a voice could move',
    remedy: 'open an avatar with blendshapes',
  })
}
