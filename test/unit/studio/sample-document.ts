import { type GrayImage, parseDrivers, type WrinkleDriver } from 'furrow'
import { parseStrokes, type Stroke } from 'furrow/author'
import {
  LAYER_DEFAULTS,
  type LayerStroke,
  type StudioArea,
  type StudioDocument,
} from '../../../studio/src/document/document.ts'
import { type Sculpted, sculptedOf } from '../../../studio/src/document/sculpted.ts'
import { across } from '../../strokes.ts'

const AREA_SIZE = 4

export function weightsOf(value: number): GrayImage {
  return { width: AREA_SIZE, height: AREA_SIZE, data: new Uint8Array(AREA_SIZE ** 2).fill(value) }
}

export function areaOf(name: string, layer: string, value = 100): StudioArea {
  return { name, layer, combine: 'sum', activation: 0, weights: weightsOf(value) }
}

export function strokeOf(layer: string, group: string, v = 0.5): LayerStroke {
  const points = across(v)
  const stroke = { layer, group, points, width: 2, depth: 0.5 }
  return parseStrokes({ version: 1, strokes: [stroke] }).strokes[0] as Stroke as LayerStroke
}

/** Drivers of every type that names areas. */
export const DRIVERS: readonly WrinkleDriver[] = parseDrivers(
  [
    { type: 'morph', area: 'forehead', targets: [{ name: 'browInnerUp' }] },
    { type: 'morph', area: 'frown', targets: [{ name: 'browDownLeft' }] },
    { type: 'area', area: 'cheeks', areas: [{ name: 'forehead' }, { name: 'frown' }] },
    { type: 'area', area: 'cheeks', areas: [{ name: 'frown' }] },
    { type: 'muscle', name: 'corrugator', area: 'frown', origin: [0, 0, 0], insertion: [0, 0, 1] },
    { type: 'conflict', targets: ['browInnerUp', 'browDownLeft'] },
    {
      type: 'expression',
      name: 'angry',
      targets: [{ name: 'browDownLeft' }],
      activations: [{ area: 'frown', activation: 1 }, { area: 'cheeks' }],
    },
  ],
  ['forehead', 'frown', 'cheeks'],
)

/** Sculpted heights for maps of 64 x 64 texels: the row `y` is 0.5 mm high, and its first texel 1.234 mm deep. */
export function sculptedAt(y: number): Sculpted {
  const data = new Float32Array(64 ** 2).fill(0.5, y * 64, (y + 1) * 64)
  data[y * 64] = -1.234
  return sculptedOf({ width: 64, height: 64, data })
}

/** Makes a document of two layers, three areas, three strokes with shapes, and DRIVERS. */
export function sampleDocument(): StudioDocument {
  const normal = { mimeType: 'image/png', bytes: Uint8Array.of(1, 2, 3) }
  return {
    mesh: 'Head',
    material: 'Skin',
    scale: 1000,
    mapSize: 64,
    areaSize: AREA_SIZE,
    layers: [
      { ...LAYER_DEFAULTS, name: 'up', maps: { normal } },
      { ...LAYER_DEFAULTS, name: 'down', sculpted: sculptedAt(3) },
    ],
    areas: [areaOf('forehead', 'up'), areaOf('frown', 'down'), areaOf('cheeks', 'down')],
    strokes: [
      strokeOf('up', 'forehead', 0.2),
      strokeOf('down', 'frown', 0.4),
      strokeOf('down', 'frown', 0.5),
    ],
    strokeAreas: [
      { name: 'forehead', shapes: [{ group: 'forehead', radius: 4, feather: 4 }] },
      {
        name: 'frown',
        shapes: [{ group: 'frown', radius: 4, feather: 4 }],
        within: { group: 'forehead', radius: 9, feather: 4 },
      },
    ],
    drivers: DRIVERS,
    shapes: [
      { mesh: 'Head', target: 'key_12', shape: 'browInnerUp' },
      { mesh: 'Head', target: 'Fcl' },
    ],
    auto: {
      age: 45,
      strength: 1,
      size: 64,
      seed: 1,
      symmetry: 0.5,
      strengths: { crowsFeetLeft: 2.5, chin: 0 },
      densities: { nose: 1.5 },
      shapes: [{ mesh: 'Head', target: 'key_12', shape: 'browInnerUp' }],
    },
    takes: [
      { name: 'Smile', motion: { names: ['jawOpen'], weights: Float32Array.of(0, 0.12345, 1) } },
      {
        name: 'Frown/1',
        motion: { names: ['a', 'b'], weights: Float32Array.of(0, 1, 1, 0) },
        range: [0, 1 / 60],
      },
    ],
  }
}

/** Freezes a document, so that modifying it throws an error. */
export function frozen<T>(value: T): T {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value)) return value
  for (const part of Object.values(value)) frozen(part)
  return Object.freeze(value)
}

/** Returns a function that runs tasks, and the messages of those that failed. */
export function attempts() {
  const errors: string[] = []
  const attempt = (task: () => void) => {
    try {
      task()
    } catch (error) {
      errors.push((error as Error).message)
    }
  }
  return { errors, attempt }
}
