import { isSlice } from './check-areas.ts'
import { checkSizes } from './pack.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from './types.ts'

/** Image layout, then the kinds of maps that share an array. */
const ARRAYS = [
  ['RGBA', 'normal'],
  ['RGBA', 'baseColor'],
  ['gray', 'roughness'],
  ['gray', 'occlusion'],
  ['gray', 'blood'],
  ['gray', 'occlusion', 'blood'],
] as const

/**
 * Checks that the images of each kind have one size, because each kind becomes one array.
 *
 * @throws FurrowError if sizes differ.
 */
export function checkMapSizes(layers: readonly Layer<ArraySlice>[]): void {
  for (const [layout, ...kinds] of ARRAYS) {
    const maps = kinds.flatMap((kind) => layers.flatMap((layer) => layer[kind] ?? []))
    if (maps.length === 0 || maps.some(isSlice)) continue
    checkSizes(
      maps as (GrayImage | RgbaImage)[],
      layout,
      `Wrinkles ${kinds.join(' and ')} maps of the layers`,
    )
  }
}
