import { JsonReader } from '../../core/json.ts'

/** Calibration of one blendshape. All values are scores of the source. */
export interface ShapeCalibration {
  /** Mean score of the neutral face. */
  neutral: number
  /** Standard deviation of the neutral face's scores. */
  noise: number
  /** Highest score that the person reached; 1 if none was recorded. */
  extreme: number
}

/** Calibration of a `FaceTracker` as JSON. */
export interface FaceCalibration {
  /** Version of the format. */
  version: 1
  /** Calibrations by canonical blendshape name, such as `browDownLeft`, of the person's own left and right. */
  shapes: Record<string, ShapeCalibration>
}

const MAX_SHAPES = 512

/** Smallest difference of neutral and extreme. */
const MIN_EXTENT = 0.001

/** Scores are 0..1. Some sources exceed the range slightly. */
const RANGE = [-4, 4] as const

/**
 * Checks a calibration document.
 *
 * @param value parsed JSON.
 * @throws FurrowError for a wrong version, unknown fields, numbers out of range, and more than 512 shapes.
 */
export function parseCalibration(value: unknown, who: string): FaceCalibration {
  const json = new JsonReader(who)
  const document = json.object(value, 'calibration', ['version', 'shapes'])
  json.choice(document.version, 'calibration.version', [1 as never])
  const entries = Object.entries(json.object(document.shapes, 'calibration.shapes'))
  json.array(entries, 'calibration.shapes', 0, MAX_SHAPES)
  const shapes = Object.create(null) as Record<string, ShapeCalibration>
  for (const [name, each] of entries) {
    const path = `calibration.shapes.${json.name(name, 'calibration.shapes: a name')}`
    const fields = json.object(each, path, ['neutral', 'noise', 'extreme'])
    const neutral = json.number(fields.neutral, `${path}.neutral`, ...RANGE, '')
    shapes[name] = {
      neutral,
      noise: json.number(fields.noise, `${path}.noise`, 0, RANGE[1], ''),
      extreme: json.number(fields.extreme, `${path}.extreme`, neutral + MIN_EXTENT, 2 * RANGE[1], ''),
    }
  }
  return { version: 1, shapes }
}
