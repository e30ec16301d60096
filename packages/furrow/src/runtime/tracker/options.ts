import { isObject, wrongArgument } from '../../core/argument.ts'
import { checkOptionNames } from '../../core/nearest-name.ts'
import type { OneEuroOptions } from './one-euro.ts'

/** Options of `FaceTracker`; defaults are in `FACE_TRACKER_DEFAULTS`. */
export interface FaceTrackerOptions {
  /**
   * Parameters of the filter that removes jitter. `null` applies scores as they are, for sources that are smooth already: without a filter,
   * and by default without dead zone and substitutes.
   */
  filter?: Partial<OneEuroOptions> | null
  /** Weights up to this number become 0. Weights above its triple are unchanged. The noise of the neutral recording widens the zone. */
  deadZone?: number
  /** Factors for calibrated scores, by blendshape name in any spelling, such as `{ browDownLeft: 1.5 }`. */
  gains?: Readonly<Record<string, number>>
  /** Whether the person's left side moves the right side of the face, as in a mirror. */
  mirror?: boolean
  /** Whether to estimate `noseSneer` and `cheekSquint` from other scores if the source does not deliver them. */
  substitutes?: boolean
}

/** Defaults of `FaceTrackerOptions`. `deadZone` is 0 and `substitutes` is false if `filter` is `null`. */
export const FACE_TRACKER_DEFAULTS = {
  // `bench/tracker` compares the filter with its targets.
  filter: { minCutoff: 0.9, beta: 12, speedCutoff: 0.8, noiseSpeed: 0.85 },
  deadZone: 0.04,
  gains: {},
  mirror: false,
  substitutes: true,
} as const satisfies Required<FaceTrackerOptions>

/** Checked options with defaults. */
export interface TrackerSettings extends Required<FaceTrackerOptions> {
  filter: Readonly<OneEuroOptions> | null
}

/** @throws FurrowError for an unknown or invalid option. */
export function trackerSettings(options: FaceTrackerOptions, who: string): TrackerSettings {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  checkOptionNames(options, Object.keys(FACE_TRACKER_DEFAULTS), who)
  const isRaw = options.filter === null
  if (!isRaw && options.filter !== undefined && !isObject(options.filter)) {
    throw wrongArgument(who, 'option filter', options.filter, 'an object or null')
  }
  checkOptionNames(options.filter ?? {}, Object.keys(FACE_TRACKER_DEFAULTS.filter), who)
  const filter = options.filter === null ? null : { ...FACE_TRACKER_DEFAULTS.filter, ...options.filter }
  const settings = {
    ...FACE_TRACKER_DEFAULTS,
    ...(isRaw && { deadZone: 0, substitutes: false }),
    ...Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)),
    filter,
  }
  for (const [name, value] of Object.entries(filter ?? {})) {
    const isPositive = name === 'minCutoff' || name === 'speedCutoff'
    if (!(Number.isFinite(value) && (isPositive ? value > 0 : value >= 0))) {
      throw wrongArgument(
        who,
        `option filter.${name}`,
        value,
        `a number ${isPositive ? 'above 0' : 'from 0'}`,
      )
    }
  }
  if (!(settings.deadZone >= 0 && settings.deadZone <= 0.3)) {
    throw wrongArgument(who, 'option deadZone', settings.deadZone, '0..0.3')
  }
  if (!isObject(settings.gains)) throw wrongArgument(who, 'option gains', settings.gains, 'an object')
  for (const [name, gain] of Object.entries(settings.gains)) {
    if (!(Number.isFinite(gain) && gain >= 0)) {
      throw wrongArgument(who, `gain of ${name}`, gain, 'a number from 0')
    }
  }
  return settings
}
