import type { GrayImage } from 'furrow'
import { boundsOf, DEFAULT_AREA_SIZE, resampleGray } from 'furrow/internal'
import { areaSizes, influenceMapBytes } from 'furrow-files'
import type { StudioDocument } from './document.ts'

/** Widths and heights of areas that the studio offers, texels. */
export const AREA_SIZES = [DEFAULT_AREA_SIZE, 256, 512] as const

/** Resamples all areas to another width and height, texels. Areas that `autoWrinkles` made stay automatic. */
export function setAreaSize(document: StudioDocument, size: number): StudioDocument {
  if (size === document.areaSize) return document
  const areas = document.areas.map((area) => ({ ...area, weights: resampleGray(area.weights, size) }))
  return { ...document, areaSize: size, areas }
}

/** Cost of the areas of a face on the stage, or in an application that shows them with this size. */
export interface AreaCost {
  /** GPU memory of the uncompressed areas and of one influence map, bytes. */
  readonly bytes: number
  /**
   * Maximum number of texels that an update of the influence map writes. It clears the map, and draws the bounding rectangle of each active area.
   * It runs only in frames in which an activation changes.
   */
  readonly texels: number
}

export function areaCost({ areas, areaSize, layers }: StudioDocument): AreaCost {
  const { uncompressed } = areaSizes(areaSize, areaSize)
  return {
    bytes: areas.length * uncompressed + influenceMapBytes(areaSize, areaSize, layers.length),
    texels: areaSize ** 2 + areas.reduce((sum, { weights }) => sum + drawnTexels(weights), 0),
  }
}

/** Cache, because a stroke of the brush changes only one area. */
const texelsOf = new WeakMap<GrayImage, number>()

/** Returns the number of texels in the bounding rectangle of an area. */
function drawnTexels(weights: GrayImage): number {
  const known = texelsOf.get(weights)
  if (known !== undefined) return known
  const { x0, y0, x1, y1 } = boundsOf({ ...weights, channels: 1, depth: 1 }, 0)
  const texels = Math.max(0, x1 - x0) * Math.max(0, y1 - y0)
  texelsOf.set(weights, texels)
  return texels
}
