import type { CompressedArrayTexture, DataArrayTexture } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import type { AnyRenderer } from '../renderer.ts'

export type ArrayTexture = CompressedArrayTexture | DataArrayTexture

/** Uploads texture changes that a renderer has not uploaded yet. Called in every frame. */
export type Upload = (renderer: AnyRenderer) => void

/**
 * Returns the texture array that contains all maps.
 *
 * @param maps slices of texture arrays, or images.
 * @param label name of the maps, for errors.
 * @throws FurrowError if a map is an image, or a slice of another array.
 */
export function arrayOf(maps: readonly object[], who: string, label: string): ArrayTexture {
  const [first] = maps.filter(isSlice)
  if (maps.every((map) => isSlice(map) && map.array === first.array)) return first.array as ArrayTexture
  throw new FurrowError({
    who,
    problem: `${label} in different texture arrays`,
    limit: 'all images, or all slices of one array',
    remedy: `pack all ${label} the same way`,
  })
}
