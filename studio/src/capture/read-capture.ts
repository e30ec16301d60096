import { type Capture, readLiveLinkFace } from './live-link-face.ts'

/**
 * Reads the CSV files of a recording by the app Live Link Face, and returns the longest capture. Skips files that contain no capture, such
 * as calibration and logs.
 *
 * @param tables at least one CSV file. If none is a capture, the promise rejects with the FurrowError of the first file.
 */
export async function readCapture(tables: readonly File[]): Promise<Capture> {
  const results = await Promise.allSettled(tables.map(readLiveLinkFace))
  const captures = results.flatMap((result) => (result.status === 'fulfilled' ? result.value : []))
  if (captures.length === 0) throw (results[0] as PromiseRejectedResult).reason
  return captures.reduce((longest, each) => (each.times.length > longest.times.length ? each : longest))
}
