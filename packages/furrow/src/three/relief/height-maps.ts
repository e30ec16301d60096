import { LinearFilter } from 'three'
import { FurrowError } from '../../core/error.ts'
import { packGrays } from '../../core/pack.ts'
import type { ArraySlice, GrayImage, Layer } from '../../core/types.ts'
import { isSlice } from '../../core/wrinkle-set.ts'
import { type ArrayTexture, arrayOf } from '../material/array-texture.ts'
import { areaTexture } from '../material/textures.ts'

/** The heights of a set's layers on the GPU. */
export interface HeightMaps {
  texture: ArrayTexture
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

type Map = GrayImage | ArraySlice

/** Whether any layer can move the surface. */
export function hasHeights(layers: readonly Layer<ArraySlice>[]): boolean {
  return layers.some(({ height, heightAmplitude = 0 }) => height && heightAmplitude > 0)
}

/**
 * Creates the texture of the layers' heights.
 *
 * @throws FurrowError when maps differ in size or are in several arrays.
 */
export function createHeightMaps(layers: readonly Layer<ArraySlice>[]): HeightMaps {
  const found = layers.flatMap(({ height, heightAmplitude = 0 }, layer) =>
    height && heightAmplitude > 0 ? [{ layer, amplitude: heightAmplitude, map: height as Map }] : [],
  )
  const maps = found.map(({ map }) => map)
  const texture = maps.some(isSlice)
    ? arrayOf(maps, 'Wrinkles', 'heights')
    : areaTexture(packGrays(maps as GrayImage[], 'Wrinkles heights of the layers'))
  texture.minFilter = LinearFilter
  return {
    texture,
    channel: isSlice(maps[0]) ? maps[0].channel : 0,
    layers: found.map(({ layer, amplitude, map }, i) => ({
      layer,
      amplitude,
      slice: isSlice(map) ? map.slice : i,
    })),
    reach: found.reduce((sum, { amplitude }) => sum + amplitude / 2, 0),
    dispose: () => {
      if (!maps.some(isSlice)) texture.dispose()
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
    what: 'the heights of the layers reach too far',
    value: `${reach} m`,
    limit: `${limit.toPrecision(2)} m for a mesh of this size`,
    remedy: 'give the heights their amplitude in metres',
  })
}
