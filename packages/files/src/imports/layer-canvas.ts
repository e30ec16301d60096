import type { GrayImage } from 'furrow'
import type { Pixels } from '../images/pixels.ts'
import type { LayerToPack } from '../pack/set-to-pack.ts'
import { type Cells, cellOf, shownCells, weightedCells } from './area-cells.ts'

/** Bytes of one texel of each kind of map that is not visible. Equal texels compress well. */
const BLANK = {
  normal: [128, 128, 255],
  baseColor: [128, 128, 128],
  roughness: [128],
  occlusion: [255],
  onset: [0],
}

export type CanvasMap = keyof typeof BLANK

/** Texels of a map for one area. */
export interface PaintedArea {
  weights: GrayImage
  colourAt(texel: number): ArrayLike<number>
}

/** Maps of one layer while they are painted. Only texels that an area shows are painted; all others stay blank. */
export class LayerCanvas {
  readonly #size: number
  readonly #maps = new Map<CanvasMap, Uint8Array>()

  constructor(size: number) {
    this.#size = size
  }

  /**
   * Paints the texels that areas can show. Texels around an area, which interpolation reaches, do not cover another area.
   *
   * @param areas weights of each area, and a function that returns the bytes of a texel, one per channel of the map.
   */
  paint(map: CanvasMap, areas: readonly PaintedArea[]): void {
    const channels = BLANK[map].length
    const data = this.#maps.get(map) ?? this.#blank(map)
    this.#maps.set(map, data)
    const fill = ({ side, data: cells }: Cells, colourAt: PaintedArea['colourAt']) => {
      for (let i = 0; i < this.#size ** 2; i++) {
        if (cells[cellOf(i, this.#size, side)]) data.set(colourAt(i), channels * i)
      }
    }
    for (const { weights, colourAt } of areas) fill(shownCells(weights), colourAt)
    for (const { weights, colourAt } of areas) fill(weightedCells(weights), colourAt)
  }

  /** Returns functions that load the painted maps. */
  maps(): LayerToPack['maps'] {
    const entries = [...this.#maps].map(([map, data]) => {
      const pixels = { width: this.#size, height: this.#size, channels: BLANK[map].length, data } as Pixels
      return [map, async () => pixels] as const
    })
    return Object.fromEntries(entries) as unknown as LayerToPack['maps']
  }

  #blank(map: CanvasMap): Uint8Array {
    const blank = BLANK[map]
    const data = new Uint8Array(blank.length * this.#size ** 2)
    for (let i = 0; i < data.length; i++) data[i] = blank[i % blank.length]
    return data
  }
}

/** Returns the bytes of a normal. It need not be normalised; components beyond -1 and 1 are clamped. */
export function normalBytes(x: number, y: number, z: number): [number, number, number] {
  return [byteOf(x), byteOf(y), byteOf(z)]
}

function byteOf(value: number): number {
  return Math.min(255, Math.max(0, Math.round((value + 1) * 127.5)))
}
