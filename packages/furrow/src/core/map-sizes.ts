import { isSlice } from './check-areas.ts'
import { checkSizes } from './pack.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from './types.ts'

/** The kinds of maps that are in one array, occlusion and blood where there are both, after their layout. */
const ARRAYS = [
  ['RGBA', 'normal'],
  ['RGBA', 'baseColor'],
  ['gray', 'roughness'],
  ['gray', 'occlusion'],
  ['gray', 'blood'],
  ['gray', 'occlusion', 'blood'],
] as const

/**
 * Checks that the layers' images of each kind have one size, as those of an array must. Slices are of one array anyway.
 *
 * @throws FurrowError when they have not.
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
