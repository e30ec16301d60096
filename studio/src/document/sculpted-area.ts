import type { Uv } from 'furrow/author'
import { MAX_LAYERS } from 'furrow/internal'
import { areaAt, isBloodArea } from './area-at.ts'
import { addArea, paintArea } from './areas.ts'
import type { StudioArea, StudioDocument } from './document.ts'
import { isDriven } from './drivers.ts'
import { addLayer } from './layers.ts'
import { freeName } from './names.ts'
import type { HeightImage, Rectangle } from './sculpted.ts'

/** Name of the area and of the layer that are added for sculpted skin if no area is chosen. */
const SCULPTED = 'sculpted'
/** Minimum weight of an area at a texel, 0..255, for which it counts as shown there. */
const SHOWN = 128
/** Texels around a sculpted texel of an area that get full weight, because areas are filtered bilinearly. */
const MARGIN = 1

/** Layer that a stroke of a brush sculpts, and the name of the area that shows it. Both may not exist yet. */
export interface SculptPlace {
  readonly layer: string
  readonly area: string
}

/**
 * Returns where a stroke on the skin belongs: to the chosen area. If none is chosen, it belongs to an area that is always visible, in a layer
 * without lines, because the area would show these too. If there is no room for this layer, it belongs to the area under its start.
 */
export function sculptPlace(document: StudioDocument, chosen: StudioArea | null, uv: Uv): SculptPlace {
  const { areas, layers } = document
  if (chosen) return { layer: chosen.layer, area: chosen.name }
  const own = areas.find(
    ({ name, activation }) => activation === 1 && name.startsWith(SCULPTED) && !isDriven(document, name),
  )
  if (own) return { layer: own.layer, area: own.name }
  const layer = layers.find(({ name }) => name.startsWith(SCULPTED))?.name
  const area = freeName(areas, SCULPTED)
  if (layer !== undefined) return { layer, area }
  if (layers.length < MAX_LAYERS) return { layer: freeName(layers, SCULPTED), area }
  const wrinkled = areas.filter((each) => !isBloodArea(each))
  const under = areaAt(wrinkled, uv)
  const found = wrinkled.find(({ name }) => name === under)
  return found ? { layer: found.layer, area: found.name } : { layer: layers[0].name, area }
}

/** Adds the layer of a stroke if it does not exist. */
export function addSculptedLayer(document: StudioDocument, { layer }: SculptPlace): StudioDocument {
  return document.layers.some(({ name }) => name === layer) ? document : addLayer(document, layer)
}

/**
 * Extends an area, so that it shows all that a stroke has sculpted. Adds the area if it does not exist.
 *
 * @param before heights before the stroke.
 * @param after heights with the stroke.
 * @param changed rectangle that contains the changed texels.
 */
export function coverSculpted(
  document: StudioDocument,
  { layer, area }: SculptPlace,
  before: HeightImage,
  after: HeightImage,
  changed: Rectangle,
): StudioDocument {
  const { areas, areaSize } = document
  const own = areas.find(({ name }) => name === area)
  const data = own ? own.weights.data.slice() : new Uint8Array(areaSize ** 2)
  let isGrown = false
  for (const texel of sculptedTexels(before, after, changed, areaSize)) {
    // Other areas of the layer do not count, because they can be hidden while this one is visible.
    if (data[texel] >= SHOWN) continue
    isGrown = true
    const [x, y] = [texel % areaSize, Math.floor(texel / areaSize)]
    for (let row = Math.max(y - MARGIN, 0); row <= Math.min(y + MARGIN, areaSize - 1); row++) {
      const first = Math.max(x - MARGIN, 0)
      data.fill(255, row * areaSize + first, row * areaSize + Math.min(x + MARGIN, areaSize - 1) + 1)
    }
  }
  if (!isGrown) return document
  const weights = { width: areaSize, height: areaSize, data }
  if (own) return paintArea(document, area, weights)
  return addArea(document, { name: area, layer, combine: 'sum', activation: 1, weights })
}

/** Returns the texels of an area in which heights have changed. */
function sculptedTexels(
  before: HeightImage,
  after: HeightImage,
  { x, y, width, height }: Rectangle,
  areaSize: number,
): Set<number> {
  const texels = new Set<number>()
  const scale = areaSize / after.width
  for (let row = y; row < y + height; row++) {
    for (let column = x; column < x + width; column++) {
      const i = row * after.width + column
      if (before.data[i] === after.data[i]) continue
      texels.add(Math.floor((row + 0.5) * scale) * areaSize + Math.floor((column + 0.5) * scale))
    }
  }
  return texels
}
