import { JsonReader, orDefault, type Uv } from '../../core/json.ts'
import { MAX_AREAS, MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { type Furrows, readFurrows } from '../furrows/read-furrows.ts'
import { MILLIMETRES_PER_METRE } from '../metric.ts'
import { type AreaDefinition, type AreaShape, readAreaDefinitions } from './area-definitions.ts'

export type { AreaDefinition, AreaShape, Uv }

/** Interpolation of a stroke's points; see `Stroke.curve`. */
export type CurveKind = 'polyline' | 'bezier' | 'spline'

const CURVES = ['polyline', 'bezier', 'spline'] as const satisfies CurveKind[]

/** Wrinkle: a curve on the skin with a measured cross-section. */
export interface Stroke {
  /** Name of the area that shows the stroke. */
  group?: string
  /** Name of the stroke's layer, in documents with several layers. */
  layer?: string
  /**
   * Interpolation of the points:
   *
   * - `polyline`: straight lines in UV space.
   * - `bezier`: n cubic Bezier curves in UV space through 3 n + 1 points, with two handles between ends.
   * - `spline`: a smooth curve over the skin (centripetal Catmull-Rom), the only kind that crosses UV seams.
   */
  curve: CurveKind
  /** [u, v], both 0..1, v = 0 at the top. */
  points: Uv[]
  /** Full width of the valley on the skin in millimetres, 0.1..50; with full shoulders, the height is zero at its edges. */
  width: number
  /** Maximum depth of the valley below the skin in millimetres, 0..10. */
  depth: number
  /** Factors on the depth, 0..1, evenly spaced from start to end, at least 2; default 1. */
  depths?: number[]
  /** Fractions of the length, 0..1, over which the wrinkle fades in at its start and out at its end. */
  taper: [start: number, end: number]
  /** Raised banks, 0..1, left and right along the curve as seen from outside. At 1 they hold all the skin pushed out of the valley. */
  shoulder: [left: number, right: number]
  /** Reach of the banks from the bottom, left and right, in millimetres, 0.1..100; default 2.2 widths. */
  bank?: [left: number, right: number]
  /** Asymmetry, -0.9..0.9, default 0: the half widths are 1 - lean (left) and 1 + lean (right) times their mean. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1: 0 = a sharp fold, 1 = as round as the valley is wide. */
  softness: number
  /** Irregularity, 0..1: the line meanders and its depth varies, deterministically. */
  waviness: number
}

/** Strokes of one or several layers, and optionally the areas that show them. */
export interface StrokesDocument {
  version: 1
  /** Millimetres per unit of the face's positions, more than 0: 1000 for a life-size face in metres. */
  scale: number
  /** Default side of the maps in texels, 16..8192. */
  size?: number
  strokes: Stroke[]
  /** Net of fine furrows between the strokes. */
  furrows?: Furrows
  /** Soft shapes that become the areas. Default: one area around the strokes of each group. */
  areas?: AreaDefinition[]
}

/** Minimum and maximum millimetres per unit of a face. */
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
 * @throws FurrowError with the field's path if anything is malformed or unknown.
 */
export function parseStrokes(json: unknown): StrokesDocument {
  const read = new JsonReader('parseStrokes')
  const root = read.object(json, 'the document', ['version', 'scale', 'size', 'strokes', 'furrows', 'areas'])
  if (root.version !== 1) read.fail('unknown version', root.version, '1', 'write "version": 1')
  const document: StrokesDocument = {
    version: 1,
    scale: read.number(orDefault(root.scale, MILLIMETRES_PER_METRE), 'scale', ...SCALE_RANGE, 'mm per unit'),
    strokes: read.array(root.strokes, 'strokes', 1, 10_000).map((stroke, i) => readStroke(read, stroke, i)),
  }
  if (root.size !== undefined) document.size = readSize(read, root.size)
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
    width: read.number(field.width, `${path}.width`, 0.1, 50, 'mm'),
    depth: read.number(field.depth, `${path}.depth`, 0, 10, 'mm'),
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
