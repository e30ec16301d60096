import { fillGaps } from './fill-gaps.ts'

/** Frame rates of cameras, frames per second. The last one is the default of the app Live Link Face. */
const RATES = [24, 25, 30, 48, 50, 60] as const
/** Seconds per day, after which timecodes wrap around. */
const DAY = 86_400

/** Time of day at which a frame was captured. */
export interface Timecode {
  /** Integer seconds since midnight. */
  seconds: number
  /** Number of the frame within the second. Can have a fraction. */
  frames: number
}

/** Parses `HH:MM:SS:FF` or `HH:MM:SS:FF.fraction`; `;` before the frames marks drop-frame timecode. Returns null if invalid. */
export function parseTimecode(text: string): Timecode | null {
  const parts = /^(\d{1,2}):(\d{1,2}):(\d{1,2})[:;](\d{1,3}(?:\.\d+)?)$/.exec(text)
  if (!parts) return null
  const [hours, minutes, seconds, frames] = parts.slice(1).map(Number)
  return { seconds: 3600 * hours + 60 * minutes + seconds, frames }
}

/**
 * Converts timecodes to seconds since the first one. The recording can pass midnight. Infers the frame rate from the largest frame number.
 * Interpolates unknown timecodes, which are null.
 */
export function secondsSinceFirst(timecodes: readonly (Timecode | null)[]): number[] {
  const known = timecodes.filter((timecode) => timecode !== null)
  const rate = known.length > 0 ? rateOf(known) : RATES.at(-1)!
  let [days, last] = [0, 0]
  const moments = timecodes.map((timecode) => {
    if (!timecode) return Number.NaN
    const moment = timecode.seconds + timecode.frames / rate
    if (last - moment > DAY / 2) days++
    last = moment
    return moment + DAY * days
  })
  const filled = fillGaps(moments, 1 / rate)
  return filled.map((moment) => moment - filled[0])
}

function rateOf(timecodes: readonly Timecode[]): number {
  const [first] = timecodes
  const isWithinSecond = timecodes.every(({ seconds }) => seconds === first.seconds)
  // Timecodes within one second do not show the frame rate.
  if (isWithinSecond) return RATES.at(-1)!
  const largest = timecodes.reduce((most, { frames }) => Math.max(most, Math.floor(frames)), 0)
  return RATES.find((rate) => largest < rate) ?? largest + 1
}
