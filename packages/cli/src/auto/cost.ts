import type { AutoWrinkles } from 'furrow/author'
import type { PackedWrinkles } from '../wrinkles/embed.ts'
import { areaSizes, areaSliceSizes, influenceMapBytes, mapSizes } from '../wrinkles/sizes.ts'

/** What the wrinkles of a file cost, in bytes. */
export interface Cost {
  /** Of their images in the file. */
  file: number
  /** Of their maps, areas and one influence map on a GPU: of a desktop, where it can compress. */
  gpu: number
}

/** What automatic wrinkles cost as they are packed. Heights stay in the file. */
export function costOf({ layers, areas }: AutoWrinkles, packed: PackedWrinkles, ktx2: boolean): Cost {
  const images = [
    ...packed.layers.flatMap(({ normal, occlusion, height }) => [normal, occlusion, height]),
    ...packed.areas.map(({ image }) => image),
  ]
  const files = new Set(images.map((image) => image?.bytes))
  const { width: side } = layers[0].normal
  const { width, height } = areas[0].weights
  const encoding = ktx2 ? 'bits4' : 'uncompressed'
  const layer = mapSizes(side, side)[encoding] + mapSizes(side / 2, side / 2)[encoding]
  const slices = new Set(packed.areas.map(({ image }) => image))
  const areaBytes = ktx2
    ? slices.size * areaSliceSizes(width, height).bits8
    : areas.length * areaSizes(width, height).uncompressed
  return {
    file: [...files].reduce((sum, bytes) => sum + (bytes?.length ?? 0), 0),
    gpu: layers.length * layer + areaBytes + influenceMapBytes(width, height, layers.length),
  }
}
