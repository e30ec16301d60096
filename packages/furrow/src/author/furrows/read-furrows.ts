import { type JsonReader, or } from '../../core/json.ts'

/** The net of fine furrows that covers all skin. */
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
}

/**
 * A net of adult skin. Furrows of the forearm are some hundredths of a millimetre deep until forty, and deepen to more than 0.1 mm after eighty
 * (Makki et al. 1983, Skin relief and aging, J Soc Cosmet Chem 34); the size is an estimate.
 */
export const FURROW_DEFAULTS = { size: 1.5, depth: 0.05, stretch: 1.6, seed: 1 } as const satisfies Furrows

/** Reads the `furrows` of a strokes document. Throws FurrowError through `read`. */
export function readFurrows(read: JsonReader, json: unknown): Furrows {
  const field = read.object(json, 'furrows', ['size', 'depth', 'stretch', 'seed', 'layer'])
  const furrows: Furrows = {
    size: read.number(or(field.size, FURROW_DEFAULTS.size), 'furrows.size', 0.2, 20, 'mm'),
    depth: read.number(or(field.depth, FURROW_DEFAULTS.depth), 'furrows.depth', 0, 2, 'mm'),
    stretch: read.number(or(field.stretch, FURROW_DEFAULTS.stretch), 'furrows.stretch', 1, 2, ''),
    seed: read.integer(or(field.seed, FURROW_DEFAULTS.seed), 'furrows.seed', 0, 2 ** 31 - 1),
  }
  if (field.layer !== undefined) furrows.layer = read.name(field.layer, 'furrows.layer')
  return furrows
}
