import { type JsonReader, orDefault, type Uv } from '../../core/json.ts'

/** Pattern of fine furrows that divide the skin into small cells. */
export interface Furrows {
  /** Mean distance between the centres of neighbouring cells in millimetres, 0.2..20. */
  size: number
  /** Maximum depth of a furrow in millimetres, 0..2. */
  depth: number
  /** Ratio of a cell's length along nearby wrinkle lines to its width, 1..2. */
  stretch: number
  /** Random seed, 0..2^31 - 1. The same seed gives the same pattern. */
  seed: number
  /** Name of the layer that contains the pattern, in documents with several layers. */
  layer?: string
  /** Parts of the skin that have furrows, each with its size and depth. Default: all skin, with `size` and `depth`. */
  regions?: FurrowRegion[]
}

/** Part of the skin with furrows, inside a sphere. Overlapping regions blend. */
export interface FurrowRegion {
  /** Centre on the skin: [u, v], both 0..1, v = 0 at the top. */
  at: Uv
  /** Radius in millimetres, 1..1000. Furrows have their full depth up to about half this distance from the centre and fade out beyond. */
  radius: number
  /** Replaces `Furrows.size` in the region. */
  size: number
  /** Replaces `Furrows.depth` in the region. */
  depth: number
}

/** Furrows of adult skin. The values are between those of `furrow auto` for cheeks at 30 and at 70 years (sources in docs/auto-furrows.md). */
export const FINE_FURROW_DEFAULTS = {
  size: 1.5,
  depth: 0.05,
  stretch: 1.6,
  seed: 1,
} as const satisfies Furrows

const MAX_REGIONS = 64

/**
 * Reads and checks the field `furrows` of a strokes document.
 *
 * @throws FurrowError if a field is invalid.
 */
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
