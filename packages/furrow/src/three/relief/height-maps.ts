import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import type { ImageArray } from '../../core/image-array.ts'
import { packGrays } from '../../core/pack.ts'
import type { GrayImage } from '../../core/types.ts'
import { type ArrayTexture, arrayOf } from '../material/array-texture.ts'
import { mapTexture } from '../material/textures.ts'
import { hasHeights, type RaisedLayer } from './raised-layer.ts'

/** Height maps of a set's layers. */
export interface HeightMaps {
  texture: ArrayTexture
  /** CPU copy of the texture; null if it is compressed. */
  array: ImageArray | null
  /** Channel of the texture, 0 = R to 3 = A. */
  channel: number
  /** Layers with heights. */
  layers: readonly HeightLayer[]
  /** Maximum outward displacement, all layers together, metres. */
  reach: number
  /** Disposes of the texture, unless it belongs to the wrinkle set. */
  dispose(): void
}

export interface HeightLayer {
  layer: number
  slice: number
  /** Displacement from black to white, metres. */
  amplitude: number
}

/**
 * Creates the height texture of the layers. Decodes heights that the file has deferred.
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

/** Maximum displacement relative to a mesh's radius. Larger values indicate wrong units. */
const MAX_REACH = 0.05

/**
 * Checks heights against the size of a mesh.
 *
 * @param radius radius of the mesh's bounding sphere, metres.
 * @throws FurrowError if the heights are too large.
 */
export function checkReach({ reach }: HeightMaps, radius: number): void {
  const limit = MAX_REACH * radius
  if (reach <= limit) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Wrinkles.relief',
    problem: 'the heights of the layers reach too far',
    value: `${reach} m`,
    limit: `${limit.toPrecision(2)} m for a mesh of this size`,
    remedy: 'set heightAmplitude in metres',
  })
}
