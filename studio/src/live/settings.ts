export const SOURCE_NAMES = ['webcam', 'phone', 'microphone'] as const
export type SourceName = (typeof SOURCE_NAMES)[number]

/** Choices of the user. */
export interface LiveSettings {
  readonly source: SourceName
  /** Address that `furrow live` prints. */
  readonly address: string
  /** Address of the folder of MediaPipe, and of its model. */
  readonly library: string
  readonly model: string
  /** Whether the person's left side moves the right side of the face. */
  readonly mirror: boolean
  /** Whether to remove jitter. */
  readonly isSmooth: boolean
}

export const LIVE_DEFAULTS: LiveSettings = {
  source: 'webcam',
  address: '',
  library: 'https://cdn.jsdelivr.net/npm/@mediapipe/tasks-vision@1.1.0',
  model:
    'https://storage.googleapis.com/mediapipe-models/face_landmarker/face_landmarker/float16/1/face_landmarker.task',
  mirror: true,
  isSmooth: true,
}

/** Key of `localStorage`. */
const KEY = 'furrow-live'

/** Returns the settings that were stored in this browser, or defaults. */
export function readSettings(): LiveSettings {
  try {
    const stored: Record<string, unknown> = JSON.parse(localStorage.getItem(KEY) ?? '{}')
    const valid = Object.entries(LIVE_DEFAULTS).filter(
      ([name, value]) => typeof stored[name] === typeof value,
    )
    const settings = { ...LIVE_DEFAULTS, ...Object.fromEntries(valid.map(([name]) => [name, stored[name]])) }
    return SOURCE_NAMES.includes(settings.source) ? settings : LIVE_DEFAULTS
  } catch {
    return LIVE_DEFAULTS
  }
}

/** Stores the settings, except the address, which contains a secret. Does nothing if the browser denies storage. */
export function storeSettings({ address: _, ...settings }: LiveSettings): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(settings))
  } catch {}
}
