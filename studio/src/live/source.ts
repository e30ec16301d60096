import type { FrameScores } from 'furrow/three'
import type { LiveSettings } from './settings.ts'

/**
 * State of a source: `starting` loads programs and models, `connecting` and `noAnswer` wait for `furrow live`, `noScores` and `noFace` are
 * connected but without scores.
 */
export type SourceStatus =
  | 'starting'
  | 'connecting'
  | 'noAnswer'
  | 'noScores'
  | 'noFace'
  | 'connected'
  | 'lost'

export interface SourceEvents {
  /**
   * @param seconds time of the frame, increasing.
   * @param sender who made the scores, such as `webcam` or `vmc`. Each sender has its own calibration.
   */
  onScores(scores: FrameScores, seconds: number, sender: string): void
  onStatus(status: SourceStatus): void
  /** Called when the source has ended by itself. */
  onError(error: Error): void
}

export interface RunningSource {
  stop(): void
}

/** Starts a source. Rejects with a FurrowError if that fails. */
export type StartSource = (settings: LiveSettings, events: SourceEvents) => Promise<RunningSource>
