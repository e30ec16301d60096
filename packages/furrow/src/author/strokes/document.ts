import { JsonReader, orDefault, type Uv } from '../../core/json.ts'
import { MAX_AREAS, MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { type Furrows, readFurrows } from '../furrows/read-furrows.ts'
import { MILLIMETRES_PER_METRE } from '../metric.ts'
import { type AreaDefinition, type AreaShape, readAreaDefinitions } from './area-definitions.ts'

export type { AreaDefinition, AreaShape, Uv }

/** Kind of interpolation between a stroke's points; see `Stroke.curve`. */
export type CurveKind = 'polyline' | 'bezier' | 'spline'

const CURVES = ['polyline', 'bezier', 'spline'] as const satisfies CurveKind[]

/** Wrinkle, as a curve on the skin and a cross-section: a valley between two raised banks, or a bulge. */
export interface Stroke {
  /** Name of the stroke's group. If the document defines no areas of influence, each group gets one with the group's name. */
  group?: string
  /** Name of the stroke's layer, in documents with several layers. */
  layer?: string
  /**
   * Interpolation of the points:
   *
   * - `polyline`: straight lines in UV space.
   * - `bezier`: n cubic Bezier curves in UV space from `3 * n + 1` points: one end, then two handles and an end per curve.
   * - `spline`: a smooth curve over the skin through the points (centripetal Catmull-Rom). Only splines can cross UV seams.
   */
  curve: CurveKind
  /** [u, v], both 0..1, v = 0 at the top. */
  points: Uv[]
  /**
   * Width of the valley or bulge on the skin in millimetres, 0.1..80. A bulge ends at half this width from the centre line. At the same
   * distance, a valley with `shoulder` 1 and the default `bank` has risen to the height of the surrounding skin.
   */
  width: number
  /**
   * Maximum depth of the valley below the skin in millimetres, -25..10. A negative depth is the height of a bulge, which has no valley and no
   * banks: `shoulder`, `bank` and `softness` do not apply.
   */
  depth: number
  /** At least 2 factors on the depth, 0..1, evenly spaced from the start of the stroke to its end. Default: 1 everywhere. */
  depths?: number[]
  /** Fractions of the length, 0..1, over which the wrinkle fades in at its start and out at its end. */
  taper: [start: number, end: number]
  /**
   * Strengths, 0..1, of the banks on both sides of the valley. Left and right are relative to the curve's direction, as seen from outside.
   * At 1, the banks have the same volume as the valley.
   */
  shoulder: [left: number, right: number]
  /** Distances in millimetres from the centre line to the outer ends of the banks, 0.1..100; default: 2.2 widths. */
  bank?: [left: number, right: number]
  /** Asymmetry of the valley or bulge, -0.9..0.9, default 0: `(1 - lean) / 2` of the width is left of the centre line, the rest right of it. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1: 0 = a sharp fold, 1 = a radius of half the valley's width. */
  softness: number
  /** Irregularity, 0..1: the line meanders and its depth varies. The variation is deterministic. */
  waviness: number
}

/** Wrinkles of a face as strokes, optionally with the areas of influence that the wrinkles appear in. */
export interface StrokesDocument {
  version: 1
  /** Millimetres per unit of the mesh's positions, within `SCALE_RANGE`: 1000 for a life-size face in metres. */
  scale: number
  /** Default width and height of the maps in texels, 16..8192. */
  size?: number
  /** Random seed of the automatic strokes, an integer, 0..2^31 - 1. `autoWrinkles` uses it to draw the same lines again. */
  seed?: number
  strokes: Stroke[]
  /** Pattern of fine furrows that cover the skin between the strokes. */
  furrows?: Furrows
  /** Definitions of the areas of influence. Default: one area around the strokes of each group. */
  areas?: AreaDefinition[]
}

/** Maximum of `StrokesDocument.seed`. */
const MAX_SEED = 2 ** 31 - 1

/** Minimum and maximum of `StrokesDocument.scale`. */
export const SCALE_RANGE = [1e-6, 1e6] as const

/** Default values of optional stroke fields. */
export const STROKE_DEFAULTS = {
  curve: 'polyline',
  taper: [0.3, 0.3],
  shoulder: [0.6, 0.6],
  softness: 0.4,
  waviness: 0,
} as const satisfies Partial<Stroke>

const STROKE_FIELDS = [
  'group',
  'layer',
  'curve',
  'points',
  'width',
  'depth',
  'depths',
  'taper',
  'shoulder',
  'bank',
  'lean',
  'softness',
  'waviness',
] as const

/**
 * Reads a strokes document (docs/strokes-format.md) and fills in the defaults. The input is not changed.
 *
 * @throws FurrowError with the path of a field that is malformed or unknown.
 */
export function parseStrokes(json: unknown): StrokesDocument {
  const read = new JsonReader('parseStrokes')
  const root = read.object(json, 'the document', [
    'version',
    'scale',
    'size',
    'seed',
    'strokes',
    'furrows',
    'areas',
  ])
  if (root.version !== 1) read.fail('unknown version', root.version, '1', 'write "version": 1')
  const document: StrokesDocument = {
    version: 1,
    scale: read.number(orDefault(root.scale, MILLIMETRES_PER_METRE), 'scale', ...SCALE_RANGE, 'mm per unit'),
    strokes: read.array(root.strokes, 'strokes', 1, 10_000).map((stroke, i) => readStroke(read, stroke, i)),
  }
  if (root.size !== undefined) document.size = readSize(read, root.size)
  if (root.seed !== undefined) document.seed = read.integer(root.seed, 'seed', 0, MAX_SEED)
  if (root.furrows !== undefined) document.furrows = readFurrows(read, root.furrows)
  if (root.areas !== undefined) {
    const areas = read.array(root.areas, 'areas', 1, MAX_AREAS)
    const groups = new Set(document.strokes.map((stroke) => stroke.group))
    document.areas = readAreaDefinitions(read, areas, groups)
  }
  return document
}

function readSize(read: JsonReader, value: unknown): number {
  const size = read.number(value, 'size', 16, MAX_IMAGE_SIDE, 'texels')
  if (!Number.isInteger(size)) read.fail('size must be a whole number', size, undefined, 'round it')
  return size
}

function readStroke(read: JsonReader, json: unknown, index: number): Stroke {
  const path = `strokes[${index}]`
  const field = read.object(json, path, STROKE_FIELDS)
  const curve = read.choice(orDefault(field.curve, STROKE_DEFAULTS.curve), `${path}.curve`, CURVES)
  const points = read.points(field.points, `${path}.points`, curve === 'bezier' ? 4 : 2)
  if (curve === 'bezier' && points.length % 3 !== 1) {
    const remedy = 'give one end, then two handles and an end per curve'
    read.fail(`${path}.points do not form Bezier curves`, points.length, '4, 7, 10, ... points', remedy)
  }
  if (points.every(([u, v]) => u === points[0][0] && v === points[0][1])) {
    read.fail(`${path}.points all coincide`, points.length, undefined, 'move them apart')
  }
  const stroke: Stroke = {
    curve,
    points,
    width: read.number(field.width, `${path}.width`, 0.1, 80, 'mm'),
    depth: read.number(field.depth, `${path}.depth`, -25, 10, 'mm'),
    taper: read.pair(orDefault(field.taper, STROKE_DEFAULTS.taper), `${path}.taper`, 0, 1),
    shoulder: read.pair(orDefault(field.shoulder, STROKE_DEFAULTS.shoulder), `${path}.shoulder`, 0, 1),
    softness: read.number(orDefault(field.softness, STROKE_DEFAULTS.softness), `${path}.softness`, 0, 1, ''),
    waviness: read.number(orDefault(field.waviness, STROKE_DEFAULTS.waviness), `${path}.waviness`, 0, 1, ''),
  }
  if (field.group !== undefined) stroke.group = read.name(field.group, `${path}.group`)
  if (field.layer !== undefined) stroke.layer = read.name(field.layer, `${path}.layer`)
  if (field.lean !== undefined) stroke.lean = read.number(field.lean, `${path}.lean`, -0.9, 0.9, '')
  if (field.bank !== undefined) stroke.bank = read.pair(field.bank, `${path}.bank`, 0.1, 100)
  if (field.depths !== undefined) {
    stroke.depths = read
      .array(field.depths, `${path}.depths`, 2, 256)
      .map((factor, i) => read.number(factor, `${path}.depths[${i}]`, 0, 1, ''))
  }
  return stroke
}
