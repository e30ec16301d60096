import { JsonReader, or, type Uv } from '../../core/json.ts'
import { MAX_AREAS, MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { type Furrows, readFurrows } from '../furrows/read-furrows.ts'
import { MILLIMETRES_PER_METRE } from '../metric.ts'
import { type AreaDefinition, type AreaShape, readAreaDefinitions } from './area-definitions.ts'

export type { AreaDefinition, AreaShape, Uv }

/** How the points of a stroke are joined; see `Stroke.curve`. */
export type CurveKind = 'polyline' | 'bezier' | 'spline'

const CURVES = ['polyline', 'bezier', 'spline'] as const satisfies CurveKind[]

/** One wrinkle: a curve on the skin with a measured cross-section. */
export interface Stroke {
  /** Name of the area that shows it. */
  group?: string
  /** Name of its layer, in a document with the strokes of several. */
  layer?: string
  /**
   * `polyline`: straight lines in the texture. `bezier`: a chain of n cubic Bezier curves in the texture, of 3 n + 1 points: end, two handles,
   * end, two handles, end... `spline`: a smooth curve over the skin through the points, wherever in the texture these are: the only kind that
   * crosses its seams (centripetal Catmull-Rom).
   */
  curve: CurveKind
  /** [u, v], both 0..1, v = 0 at the top. */
  points: Uv[]
  /** Full width of the valley on the skin in millimetres, 0.1..50: where it reaches zero with full shoulders. */
  width: number
  /** Greatest depth of the valley below the skin in millimetres, 0..10. */
  depth: number
  /** Factors on the depth, 0..1, evenly spaced from the start to the end, 2 or more; 1 by default. */
  depths?: number[]
  /** Fraction of the length, 0..1, over which the wrinkle fades in at its start and out at its end. */
  taper: [start: number, end: number]
  /** Raised banks, 0..1, left and right along the curve as seen from outside: 1 = they hold all the skin pushed out of the valley. */
  shoulder: [left: number, right: number]
  /** How far the banks reach from the bottom, left and right, in millimetres, 0.1..100; 2.2 widths by default. */
  bank?: [left: number, right: number]
  /** Steeper on the left than on the right, -0.9..0.9, 0 by default: the half widths are 1 - lean and 1 + lean times their mean. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1: 0 = a sharp fold, 1 = as round as the valley is wide. */
  softness: number
  /** Irregularity, 0..1: the line meanders and its depth varies, the same on every run. */
  waviness: number
}

/** The strokes of a layer, or of several, and optionally the areas that show them. */
export interface StrokesDocument {
  version: 1
  /** Millimetres per unit of the face's positions, more than 0: 1000 for a face of natural size. */
  scale: number
  /** Default side of the maps in texels, 16..8192. */
  size?: number
  strokes: Stroke[]
  /** The net of fine furrows between the strokes. */
  furrows?: Furrows
  /** Soft shapes that become the areas; by default every group becomes an area round its strokes. */
  areas?: AreaDefinition[]
}

/** Least and most millimetres per unit of a face. */
export const SCALES = [1e-6, 1e6] as const

/** Values of the fields that a document omits. */
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
 * @throws FurrowError that names the field by its path, for anything malformed, unknown fields included.
 */
export function parseStrokes(json: unknown): StrokesDocument {
  const read = new JsonReader('parseStrokes')
  const root = read.object(json, 'the document', ['version', 'scale', 'size', 'strokes', 'furrows', 'areas'])
  if (root.version !== 1) read.fail('unknown version', root.version, '1', 'write "version": 1')
  const document: StrokesDocument = {
    version: 1,
    scale: read.number(or(root.scale, MILLIMETRES_PER_METRE), 'scale', ...SCALES, 'mm per unit'),
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
  const curve = read.choice(or(field.curve, STROKE_DEFAULTS.curve), `${path}.curve`, CURVES)
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
    taper: read.pair(or(field.taper, STROKE_DEFAULTS.taper), `${path}.taper`, 0, 1),
    shoulder: read.pair(or(field.shoulder, STROKE_DEFAULTS.shoulder), `${path}.shoulder`, 0, 1),
    softness: read.number(or(field.softness, STROKE_DEFAULTS.softness), `${path}.softness`, 0, 1, ''),
    waviness: read.number(or(field.waviness, STROKE_DEFAULTS.waviness), `${path}.waviness`, 0, 1, ''),
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
