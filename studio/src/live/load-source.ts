import type { FaceTracker } from 'furrow/three'
import type { SourceName } from './settings.ts'
import type { StartSource } from './source.ts'

/** Code of a source, and of the tracker that applies its scores. */
export interface SourceCode {
  readonly start: StartSource
  readonly Tracker: typeof FaceTracker
}

/** Loads the code of a source. Pages that use no live source do not download it. */
export async function loadSource(source: SourceName): Promise<SourceCode> {
  const [start, { FaceTracker }] = await Promise.all([loadStart(source), import('./face-tracker.ts')])
  return { start, Tracker: FaceTracker }
}

async function loadStart(source: SourceName): Promise<StartSource> {
  if (source === 'webcam') return (await import('./webcam.ts')).startWebcam
  if (source === 'phone') return (await import('./phone.ts')).startPhone
  return (await import('./microphone.ts')).startMicrophone
}
