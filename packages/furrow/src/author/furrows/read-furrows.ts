import { type JsonReader, orDefault, type Uv } from '../../core/json.ts'

/** Net of fine furrows on the skin. */
export interface Furrows {
  /** Size of a cell in millimetres, 0.2..20. */
  size: number
  /** Maximum depth of a furrow in millimetres, 0..2. */
  depth: number
  /** Ratio of the length of cells along the lines of the skin to their width, 1..2. */
  stretch: number
  /** Random seed, 0..2^31 - 1; same seed, same net. */
  seed: number
  /** Name of the net's layer, in documents with several layers. */
  layer?: string
  /** Parts of the skin with their own sizes and depths; default: all skin. */
  regions?: FurrowRegion[]
}

/** Part of the skin, inside a sphere, with its own cells. Overlapping regions blend. */
export interface FurrowRegion {
  /** Centre on the skin: [u, v], both 0..1, v = 0 at the top. */
  at: Uv
  /** Radius in millimetres, 1..1000, where the net has faded out. */
  radius: number
  /** See `Furrows`. */
  size: number
  depth: number
}

/** Net of adult skin, between those that `furrow auto` makes for a cheek at 30 and at 70 years (sources in docs/auto.md). */
export const FINE_FURROW_DEFAULTS = {
  size: 1.5,
  depth: 0.05,
  stretch: 1.6,
  seed: 1,
} as const satisfies Furrows

const MAX_REGIONS = 64

/** Reads the `furrows` of a strokes document. Throws FurrowError through `read`. */
export function readFurrows(read: JsonReader, json: unknown): Furrows {
  const field = read.object(json, 'furrows', ['size', 'depth', 'stretch', 'seed', 'layer', 'regions'])
  const furrows: Furrows = {
    ...readCells(read, field, 'furrows', FINE_FURROW_DEFAULTS),
    stretch: read.number(orDefault(field.stretch, FINE_FURROW_DEFAULTS.stretch), 'furrows.stretch', 1, 2, ''),
    seed: read.integer(orDefault(field.seed, FINE_FURROW_DEFAULTS.seed), 'furrows.seed', 0, 2 ** 31 - 1),
  }
  if (field.layer !== undefined) furrows.layer = read.name(field.layer, 'furrows.layer')
  if (field.regions !== undefined) {
    furrows.regions = read
      .array(field.regions, 'furrows.regions', 1, MAX_REGIONS)
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
    size: read.number(orDefault(field.size, usual.size), `${path}.size`, 0.2, 20, 'mm'),
    depth: read.number(orDefault(field.depth, usual.depth), `${path}.depth`, 0, 2, 'mm'),
  }
}
