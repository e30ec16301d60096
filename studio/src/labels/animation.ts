/** Player of animations and takes, below the face. */
export const ANIMATION = {
  play: 'Play',
  pause: 'Pause',
  stop: 'Stop',
  stopHint: 'Restore the pose that the face had before',
  loop: 'Loop',
  speed: 'Speed',
  time: 'Time (s)',
  in: 'In',
  inHint: 'Begin the take at this time (I)',
  out: 'Out',
  outHint: 'End the take at this time (O)',
} as const

/** Returns the label of a clip without a name: `Clip 2`. */
export function clipLabel(number: number): string {
  return `Clip ${number}`
}

/** Returns the label of a speed: `0.5×`. */
export function speedLabel(factor: string): string {
  return `${factor}×`
}

/** Returns the time and the duration, seconds: `1.25 / 8.00 s`. */
export function timeLabel(time: number, duration: number): string {
  return `${time.toFixed(2)} / ${duration.toFixed(2)} s`
}
