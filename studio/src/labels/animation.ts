/** Player of animations and facial captures. */
export const ANIMATION = {
  none: 'This avatar has no animations. Open or drop a recording of the app Live Link Face.',
  openCapture: 'Open a recording…',
  clip: 'Clip',
  play: 'Play',
  pause: 'Pause',
  stop: 'Stop',
  stopHint: 'Restore the pose that the face had before',
  loop: 'Loop',
  speed: 'Speed',
  time: 'Time (s)',
} as const

/** Returns the label of a clip without a name: `Clip 2`. */
export function clipLabel(number: number): string {
  return `Clip ${number}`
}

/** Returns the label of a speed: `0.5×`. */
export function speedLabel(factor: string): string {
  return `${factor}×`
}
