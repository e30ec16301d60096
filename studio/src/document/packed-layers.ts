import type { HeightMap } from 'furrow/author'
import { halfSide, heightLevels } from 'furrow/internal'
import { type Pixels, withoutAlpha } from 'furrow-files'
import { type ImageFile, MAP_NAMES, type MapName, type StudioDocument, type StudioLayer } from './document.ts'
import type { DrawnMaps } from './drawn-maps.ts'
import { strokesOf } from './strokes.ts'

/** Document, and the maps that were drawn from its strokes (wrinkle lines) and sculpted heights. */
export interface DocumentToPack {
  document: StudioDocument
  /** Drawn maps. The keys are names of the layers that have strokes or sculpted heights. */
  drawn: ReadonlyMap<string, StrokeMaps>
}

export interface StrokeMaps extends DrawnMaps {
  readonly heights: HeightMap
}

/** Encoded image, or pixels that are still to be encoded. */
export type LayerMap = ImageFile | Pixels

/** Layer with the maps to write to a file. */
export interface PackedLayer {
  layer: StudioLayer
  /** Contains at least a normal map. */
  maps: { [Name in MapName]?: LayerMap }
  /** Names of the maps that are not images of the layer: they are drawn from strokes, or flat. */
  drawn: MapName[]
  heightAmplitude?: number
}

/** Returns the layers with the maps that were drawn from their strokes. A layer without a normal map gets a flat one. */
export function packedLayers({ document, drawn }: DocumentToPack): PackedLayer[] {
  const { layers, mapSize } = document
  let flat: Pixels | undefined
  return layers.map((layer): PackedLayer => {
    const strokeMaps = drawn.get(layer.name)
    const { maps: made, heightAmplitude = layer.heightAmplitude } = strokeMaps
      ? mapsOf(strokeMaps, layer, strokesOf(document, layer.name).length > 0)
      : { maps: {} }
    if (!layer.maps.normal && !made.normal) {
      flat ??= flatNormal(mapSize)
      made.normal = flat
    }
    return {
      layer,
      maps: { ...layer.maps, ...made },
      drawn: MAP_NAMES.filter((map) => made[map]),
      ...(heightAmplitude !== undefined && { heightAmplitude }),
    }
  })
}

/**
 * Makes pixels from the maps that were drawn from strokes. Occlusion, onset and heights get half the resolution of the normal map, as in `furrow auto`,
 * because steep creases are visible only in the normals. Omits the heights if the layer has a height map, and the occlusion, which sculpted
 * heights do not change, if it has no strokes.
 */
function mapsOf(
  { normal, occlusion, onset, heights }: StrokeMaps,
  layer: StudioLayer,
  hasStrokes: boolean,
): Pick<PackedLayer, 'heightAmplitude'> & { maps: { [Name in MapName]?: Pixels } } {
  const maps = {
    normal: withoutAlpha({ ...normal, channels: 4 }),
    ...(hasStrokes && { occlusion: gray(halfSide(occlusion)) }),
    ...(onset && { onset: gray(halfSide(onset)) }),
  }
  if (layer.maps.height) return { maps }
  const { levels, amplitude } = heightLevels(heights.data)
  return {
    maps: { ...maps, height: gray(halfSide({ ...heights, data: levels })) },
    heightAmplitude: amplitude,
  }
}

function gray({ width, height, data }: Omit<Pixels, 'channels'>): Pixels {
  return { width, height, channels: 1, data }
}

function flatNormal(size: number): Pixels {
  const data = new Uint8Array(3 * size ** 2).fill(128)
  for (let i = 2; i < data.length; i += 3) data[i] = 255
  return { width: size, height: size, channels: 3, data }
}
