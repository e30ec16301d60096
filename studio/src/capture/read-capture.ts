import { type Capture, readLiveLinkFace } from './live-link-face.ts'

/**
 * Reads the capture among the tables of a take, the longest where there are several: the app adds its calibration and logs.
 *
 * @param tables at least one. Rejects with the first one's FurrowError where none is a capture.
 */
export async function readCapture(tables: readonly File[]): Promise<Capture> {
  const results = await Promise.allSettled(tables.map(readLiveLinkFace))
  const captures = results.flatMap((result) => (result.status === 'fulfilled' ? result.value : []))
  if (captures.length === 0) throw (results[0] as PromiseRejectedResult).reason
  return captures.reduce((longest, each) => (each.times.length > longest.times.length ? each : longest))
}
