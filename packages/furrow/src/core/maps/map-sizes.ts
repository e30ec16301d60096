import { isSlice } from '../check-areas.ts'
import { checkSizes } from '../pack.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../types.ts'

/** Each entry is an image layout, followed by the kinds of maps that share one texture array. */
const ARRAYS = [
  ['RGBA', 'normal'],
  ['RGBA', 'baseColor'],
  ['gray', 'roughness'],
  ['gray', 'occlusion'],
  ['gray', 'blood'],
  ['gray', 'onset'],
  ['gray', 'occlusion', 'blood', 'onset'],
] as const

/**
 * Checks that all maps of one kind, such as all roughness maps, have the same size. They are packed into one texture array. Kinds with slices
 * of KTX 2 arrays are skipped.
 *
 * @throws FurrowError if sizes differ.
 */
export function checkMapSizes(layers: readonly Layer<ArraySlice>[]): void {
  for (const [layout, ...kinds] of ARRAYS) {
    const maps = kinds.flatMap((kind) => layers.flatMap((layer) => layer[kind] ?? []))
    if (maps.length === 0 || maps.some(isSlice)) continue
    const present = kinds.filter((kind) => layers.some((layer) => layer[kind]))
    checkSizes(
      maps as (GrayImage | RgbaImage)[],
      layout,
      `Wrinkles ${present.join(' and ')} maps of the layers`,
    )
  }
}
