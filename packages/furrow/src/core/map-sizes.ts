import { isSlice } from './check-areas.ts'
import { checkSizes } from './pack.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from './types.ts'

/**
 * Checks that the layers' images of each kind have one size, as those of an array must. Occlusion and blood are in one array where there
 * are both. Slices are of one array anyway.
 *
 * @throws FurrowError when they have not.
 */
export function checkMapSizes(layers: readonly Layer<ArraySlice>[]): void {
  const mapsOf = (kind: 'normal' | 'baseColor' | 'roughness' | 'occlusion' | 'blood') =>
    layers.flatMap((layer) => layer[kind] ?? [])
  const check = (maps: (GrayImage | RgbaImage | ArraySlice)[], layout: 'gray' | 'RGBA', kinds: string) => {
    if (maps.length === 0 || maps.some(isSlice)) return
    checkSizes(maps as (GrayImage | RgbaImage)[], layout, `Wrinkles ${kinds} maps of the layers`)
  }
  const [occlusion, blood] = [mapsOf('occlusion'), mapsOf('blood')]
  check(mapsOf('normal'), 'RGBA', 'normal')
  check(mapsOf('baseColor'), 'RGBA', 'baseColor')
  check(mapsOf('roughness'), 'gray', 'roughness')
  check(occlusion, 'gray', 'occlusion')
  check(blood, 'gray', 'blood')
  if (occlusion.length > 0 && blood.length > 0) {
    check([...occlusion, ...blood], 'gray', 'occlusion and blood')
  }
}
