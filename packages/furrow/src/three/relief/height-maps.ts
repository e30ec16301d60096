import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import type { ImageArray } from '../../core/image-array.ts'
import { packGrays } from '../../core/pack.ts'
import type { GrayImage } from '../../core/types.ts'
import { type ArrayTexture, arrayOf } from '../material/array-texture.ts'
import { mapTexture } from '../material/textures.ts'
import { canRise, type RaisedLayer } from './raised-layer.ts'

/** The heights of a set's layers on the GPU. */
export interface HeightMaps {
  texture: ArrayTexture
  /** The same in memory; null for compressed ones, which are on the graphics card only. */
  array: ImageArray | null
  /** Channel of the texture, 0 = R to 3 = A. */
  channel: number
  /** Those of the layers that have heights. */
  layers: readonly HeightLayer[]
  /** Metres that all of them together can move the surface outwards. */
  reach: number
  /** Frees the texture, unless it belongs to others. */
  dispose(): void
}

export interface HeightLayer {
  /** Index of the layer. */
  layer: number
  /** Slice of the texture. */
  slice: number
  /** Metres from black to white. */
  amplitude: number
}

/**
 * Creates the texture of the layers' heights, which a file may have yet to decode.
 *
 * @throws FurrowError when maps cannot be read, differ in size or are in several arrays.
 */
export async function createHeightMaps(layers: readonly RaisedLayer[]): Promise<HeightMaps> {
  const read = layers.map(async (own, layer) => {
    const map = canRise(own) && (own.height ?? (await own.readHeight?.()))
    return map ? [{ layer, amplitude: own.heightAmplitude!, map }] : []
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

/** Of the size of a mesh, what heights may reach at most: more is no wrinkle, but a mistake in the units. */
const LARGEST_REACH = 0.05

/**
 * Checks heights against the size of a mesh.
 *
 * @param radius of its bounding sphere, in metres.
 * @throws FurrowError when they reach farther than wrinkles can.
 */
export function checkReach({ reach }: HeightMaps, radius: number): void {
  const limit = LARGEST_REACH * radius
  if (reach <= limit) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Wrinkles.relief',
    problem: 'the heights of the layers reach too far',
    value: `${reach} m`,
    limit: `${limit.toPrecision(2)} m for a mesh of this size`,
    remedy: 'give the heights their amplitude in metres',
  })
}
