import type { CompressedArrayTexture, DataArrayTexture } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import type { AnyRenderer } from '../renderer.ts'

/** A texture array, compressed or not. */
export type ArrayTexture = CompressedArrayTexture | DataArrayTexture

/** Uploads what has changed since the renderer drew last; called before every frame. */
export type Upload = (renderer: AnyRenderer) => void

/**
 * The array that maps are slices of.
 *
 * @param what names the maps in errors.
 * @throws FurrowError when one of them is an image or a slice of another array.
 */
export function arrayOf(maps: readonly object[], who: string, what: string): ArrayTexture {
  const [first] = maps.filter(isSlice)
  if (maps.every((map) => isSlice(map) && map.array === first.array)) return first.array as ArrayTexture
  throw new FurrowError({
    who,
    problem: `${what} that are in different arrays`,
    limit: 'all images, or all slices of one array',
    remedy: 'pack them in the same way',
  })
}
