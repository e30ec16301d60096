/** Scores of one frame by blendshape name. Most are 0..1. */
export type Scores = Record<string, number>

/**
 * Reads a packet of one sender. Returns the scores when a frame is complete. Returns null for packets without scores, incomplete frames and
 * malformed packets.
 */
export type PacketReader = (packet: Uint8Array) => Scores | null

/** A program or device that sends scores in UDP packets. */
export interface LiveSource {
  /** UDP port to which the source sends by default. */
  port: number
  /** Creates the reader of one sender. */
  createReader: () => PacketReader
}

/** Maximum number of scores in a frame. */
export const MAX_SCORES = 256

/** Maximum length of a name in characters. */
export const MAX_NAME = 64

/** Returns the scores if all of them are finite numbers, else null. */
export function finiteOrNull(scores: Scores): Scores | null {
  return Object.values(scores).every(Number.isFinite) ? scores : null
}
