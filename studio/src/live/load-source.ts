import type { SourceName } from './settings.ts'
import type { StartSource } from './source.ts'

/** Loads the code of a source. Pages that use no live source do not download it. */
export async function loadSource(source: SourceName): Promise<StartSource> {
  if (source === 'webcam') return (await import('./webcam.ts')).startWebcam
  if (source === 'phone') return (await import('./phone.ts')).startPhone
  return (await import('./microphone.ts')).startMicrophone
}
