import { type JsonReader, or, type Uv } from '../../core/json.ts'

/** The net of fine furrows that covers skin. */
export interface Furrows {
  /** Millimetres across a cell of the net, 0.2..20. */
  size: number
  /** Greatest depth of a furrow in millimetres, 0..2. */
  depth: number
  /** How many times as long cells are along the lines of the skin as across, 1..2. */
  stretch: number
  /** 0..2^31 - 1; another one gives another net. */
  seed: number
  /** Name of its layer, in a document with the strokes of several. */
  layer?: string
  /** Where the net is, with sizes and depths of their own; all skin by default. */
  regions?: FurrowRegion[]
}

/** A part of the skin with cells of its own: what is within a sphere. Where several overlap, cells are between those of each. */
export interface FurrowRegion {
  /** Its centre, a place on the skin: [u, v], both 0..1, v = 0 at the top. */
  at: Uv
  /** Millimetres from the centre at which the net has faded out, 1..1000. */
  radius: number
  /** As of `Furrows`. */
  size: number
  depth: number
}

/** A net of adult skin, between those of a cheek at 30 and at 70 years that `furrow auto` makes (docs/auto.md has the sources). */
export const FINE_FURROW_DEFAULTS = {
  size: 1.5,
  depth: 0.05,
  stretch: 1.6,
  seed: 1,
} as const satisfies Furrows

const REGIONS_AT_MOST = 64

/** Reads the `furrows` of a strokes document. Throws FurrowError through `read`. */
export function readFurrows(read: JsonReader, json: unknown): Furrows {
  const field = read.object(json, 'furrows', ['size', 'depth', 'stretch', 'seed', 'layer', 'regions'])
  const furrows: Furrows = {
    ...readCells(read, field, 'furrows', FINE_FURROW_DEFAULTS),
    stretch: read.number(or(field.stretch, FINE_FURROW_DEFAULTS.stretch), 'furrows.stretch', 1, 2, ''),
    seed: read.integer(or(field.seed, FINE_FURROW_DEFAULTS.seed), 'furrows.seed', 0, 2 ** 31 - 1),
  }
  if (field.layer !== undefined) furrows.layer = read.name(field.layer, 'furrows.layer')
  if (field.regions !== undefined) {
    furrows.regions = read
      .array(field.regions, 'furrows.regions', 1, REGIONS_AT_MOST)
      .map((region, i) => readRegion(read, region, `furrows.regions[${i}]`, furrows))
  }
  return furrows
}

function readRegion(read: JsonReader, json: unknown, path: string, usual: CellSize): FurrowRegion {
  const field = read.object(json, path, ['at', 'radius', 'size', 'depth'])
  return {
    at: read.point(field.at, `${path}.at`),
    radius: read.number(field.radius, `${path}.radius`, 1, 1000, 'mm'),
    ...readCells(read, field, path, usual),
  }
}

type CellSize = Pick<Furrows, 'size' | 'depth'>

function readCells(
  read: JsonReader,
  field: Record<string, unknown>,
  path: string,
  usual: CellSize,
): CellSize {
  return {
    size: read.number(or(field.size, usual.size), `${path}.size`, 0.2, 20, 'mm'),
    depth: read.number(or(field.depth, usual.depth), `${path}.depth`, 0, 2, 'mm'),
  }
}
