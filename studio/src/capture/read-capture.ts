import { type Capture, readLiveLinkFace } from './live-link-face.ts'

/**
 * Reads the longest capture among the tables of a take. The app adds tables of calibration and logs.
 *
 * @param tables at least one. Rejects with the first table's FurrowError if none is a capture.
 */
export async function readCapture(tables: readonly File[]): Promise<Capture> {
  const results = await Promise.allSettled(tables.map(readLiveLinkFace))
  const captures = results.flatMap((result) => (result.status === 'fulfilled' ? result.value : []))
  if (captures.length === 0) throw (results[0] as PromiseRejectedResult).reason
  return captures.reduce((longest, each) => (each.times.length > longest.times.length ? each : longest))
}
