import { fillGaps } from './fill-gaps.ts'

/** Frames per second that cameras count in; the last is what the app counts in unless it is told otherwise. */
const RATES = [24, 25, 30, 48, 50, 60] as const
/** Seconds of a day, after which timecodes begin anew. */
const DAY = 86_400

/** A moment as cameras count it. */
export interface Timecode {
  /** Whole seconds since midnight. */
  seconds: number
  /** Frames in that second, with what is between two frames as a fraction. */
  frames: number
}

/** Reads `HH:MM:SS:FF` or `HH:MM:SS:FF.fraction`; `;` before the frames tells of dropped frame numbers. Null where it is none. */
export function parseTimecode(text: string): Timecode | null {
  const parts = /^(\d{1,2}):(\d{1,2}):(\d{1,2})[:;](\d{1,3}(?:\.\d+)?)$/.exec(text)
  if (!parts) return null
  const [hours, minutes, seconds, frames] = parts.slice(1).map(Number)
  return { seconds: 3600 * hours + 60 * minutes + seconds, frames }
}

/**
 * The moments in seconds since the first one, also over midnight. Frames are as many in a second as the largest frame asks for. A moment that is
 * unknown lies between those before and after it.
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
  // What does not see a second end may be of any rate.
  if (isWithinSecond) return RATES.at(-1)!
  const largest = timecodes.reduce((most, { frames }) => Math.max(most, Math.floor(frames)), 0)
  return RATES.find((rate) => largest < rate) ?? largest + 1
}
