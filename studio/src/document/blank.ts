import { DEFAULT_AREA_SIZE } from 'furrow/internal'
import { type AutoSettings, LAYER_DEFAULTS, type StudioDocument } from './document.ts'

/** Millimetres per unit: glTF positions are in metres. */
const MILLIMETRES = 1000

/** Makes a document without wrinkles, for artists who paint and draw all wrinkles. */
export function blankDocument(auto: AutoSettings | undefined): StudioDocument {
  return {
    scale: MILLIMETRES,
    mapSize: 1024,
    areaSize: DEFAULT_AREA_SIZE,
    layers: [{ ...LAYER_DEFAULTS, name: 'wrinkles' }],
    areas: [],
    strokes: [],
    drivers: [],
    ...(auto && { auto, mapSize: auto.size }),
  }
}
