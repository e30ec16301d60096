/** Sources of live face scores. */
export const SOURCES = {
  webcam: 'Webcam',
  phone: 'Phone or program',
  microphone: 'Microphone',
} as const

/** How to use each source. */
export const SOURCE_HINTS = {
  webcam:
    'Start downloads MediaPipe and its model (more than 10 MB). Pictures of the camera never leave this page.',
  phone: 'Run npx furrow live on this computer, and paste the address that it prints.',
  microphone: 'The loudness of your voice opens the mouth. Sound never leaves this page.',
} as const

/** Live section of the mode Motion. */
export const LIVE = {
  source: 'Source',
  address: 'Address',
  addressExample: 'ws://127.0.0.1:8765/?token=…',
  settings: 'Settings of the webcam',
  library: 'MediaPipe',
  model: 'Model',
  start: 'Start',
  stop: 'Stop live',
  stopHint: 'Restore the pose that the face had before',
  mirror: 'As in a mirror',
  mirrorHint: 'Your left side moves the side of the face that you see at the left',
  smooth: 'Remove jitter',
  calibration: 'Calibration',
  neutral: 'Relax your face (2 s)',
  neutralHint: 'Learns your relaxed face',
  range: 'Make strong expressions (10 s)',
  rangeHint: 'Learns how far you smile, frown, sneer, blink and raise your brows',
  save: 'Save calibration',
  load: 'Load calibration…',
  reset: 'Reset calibration',
  isCalibrated: 'Calibrated, and kept in this browser.',
  notCalibrated: 'Not calibrated. Relax your face for two seconds, so that it looks relaxed here too.',
  record: 'Record',
  preparing: 'Preparing…',
  finish: 'Finish take',
} as const

/** State of a source. The label of `connected` is `connectedLabel`. */
export const STATUS = {
  starting: 'Starting. Allow access if the browser asks.',
  connecting: 'Connecting.',
  noAnswer:
    'No answer. Check that furrow live runs, and paste its address again: it changes with each start.',
  noScores: 'Connected, but no scores arrive. Start the app, and enter the address of this computer in it.',
  noFace: 'No face is visible. Move into the picture, towards the light.',
  lost: 'Connection lost. Trying again.',
} as const

/** Names of senders, by the name in `furrow live`. */
const SENDERS: Readonly<Record<string, string>> = {
  webcam: 'the webcam',
  microphone: 'the microphone',
  vmc: 'a program (VMC)',
  ifacialmocap: 'iFacialMocap',
  'live-link-face': 'Live Link Face',
  openseeface: 'OpenSeeFace',
}

export function connectedLabel(sender: string): string {
  return `Connected: ${SENDERS[sender] ?? sender} moves the face.`
}

/** Returns the instruction while the page calibrates. @param left remaining seconds. */
export function calibratingLabel(kind: 'neutral' | 'range', left: number): string {
  const task = kind === 'neutral' ? 'Relax your face' : 'Smile, frown, sneer, blink, raise your brows'
  return `${task}: ${left} s`
}

export function recordedLabel(seconds: number): string {
  return `Recording: ${durationLabel(seconds)}`
}

/** Returns a duration as minutes and seconds: `1:05`. */
export function durationLabel(seconds: number): string {
  const whole = Math.round(seconds)
  return `${Math.floor(whole / 60)}:${`${whole % 60}`.padStart(2, '0')}`
}

/** Note after a take has reached the maximum length. */
export const FULL_TAKE = 'The recording stopped after 10 minutes, the maximum length of a take'

/** List of takes. */
export const TAKES = {
  none: 'No takes yet. Start a source and record one, or open a recording of the app Live Link Face.',
  open: 'Open a recording…',
  name: 'Name',
  save: 'Save as CSV',
  saveHint: 'In the layout of the app Live Link Face, which other programs read',
  whole: 'Use whole take',
  wholeHint: 'Play and export the whole take again',
  remove: 'Delete take',
} as const

export function nameOfTakeLabel(take: string): string {
  return `Name of ${take}`
}

/** Returns the name of the strongest blendshapes of a take, for the picture of their curves. */
export function curvesLabel(shapes: readonly string[]): string {
  return `Curves of ${shapes.join(', ')}`
}
