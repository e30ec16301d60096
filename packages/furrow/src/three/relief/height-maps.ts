import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import type { ImageArray } from '../../core/image-array.ts'
import { packGrays } from '../../core/pack.ts'
import type { GrayImage } from '../../core/types.ts'
import { type ArrayTexture, arrayOf } from '../material/array-texture.ts'
import { mapTexture } from '../material/textures.ts'
import { hasHeights, type RaisedLayer } from './raised-layer.ts'

/** The height maps of a wrinkle set's layers in one texture array. */
export interface HeightMaps {
  texture: ArrayTexture
  /** CPU copy of the texture; null if it is compressed. */
  array: ImageArray | null
  /** Channel of the texture, 0 = R to 3 = A. */
  channel: number
  layers: readonly HeightLayer[]
  /** Maximum displacement by all layers together, metres. */
  reach: number
  /** Disposes of the texture, unless it belongs to the wrinkle set. */
  dispose(): void
}

/** Location of a layer's height map. */
export interface HeightLayer {
  layer: number
  slice: number
  /** Difference in displacement between black and white texels, metres. */
  amplitude: number
}

/**
 * Creates the texture array of the layers' height maps. Decodes height maps that are not decoded yet.
 *
 * @throws FurrowError if maps cannot be read, differ in size, or are in several texture arrays.
 */
export async function createHeightMaps(layers: readonly RaisedLayer[]): Promise<HeightMaps> {
  const read = layers.map(async (raised, layer) => {
    const map = hasHeights(raised) && (raised.height ?? (await raised.readHeight?.()))
    return map ? [{ layer, amplitude: raised.heightAmplitude!, map }] : []
  })
  const found = (await Promise.all(read)).flat()
  const maps = found.map(({ map }) => map)
  const array = maps.some(isSlice) ? null : packGrays(maps as GrayImage[], 'Wrinkles heights of the layers')
  const texture = array ? mapTexture(array, 1) : arrayOf(maps, 'Wrinkles', 'heights')
  return {
    texture,
    array,
    channel: isSlice(maps[0]) ? maps[0].channel : 0,
    layers: found.map(({ layer, amplitude, map }, i) => ({
      layer,
      amplitude,
      slice: isSlice(map) ? map.slice : i,
    })),
    reach: found.reduce((sum, { amplitude }) => sum + amplitude / 2, 0),
    dispose: () => {
      if (array) texture.dispose()
    },
  }
}

/** Maximum displacement by one layer, relative to the radius of the mesh's bounding sphere. Larger displacements indicate wrong units. */
const MAX_REACH = 0.05

/**
 * Checks that the displacement by height maps is plausible for the size of a mesh.
 *
 * @param radius radius of the mesh's bounding sphere, metres.
 * @throws FurrowError if the heights are too large.
 */
export function checkReach({ layers }: HeightMaps, radius: number): void {
  // Layers of clothes rarely show at once, so their sum may be larger.
  const reach = Math.max(...layers.map(({ amplitude }) => amplitude / 2))
  const limit = MAX_REACH * radius
  if (reach <= limit) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Wrinkles.relief',
    problem: 'the height maps displace the surface too far',
    value: `${reach} m`,
    limit: `${limit.toPrecision(2)} m for a mesh of this size`,
    remedy: 'set heightAmplitude in metres',
  })
}
