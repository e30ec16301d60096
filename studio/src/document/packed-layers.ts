import type { HeightMap } from 'furrow/author'
import { halfSide, heightLevels } from 'furrow/internal'
import { type Pixels, withoutAlpha } from 'furrow-files'
import { type ImageFile, MAP_NAMES, type MapName, type StudioDocument, type StudioLayer } from './document.ts'
import type { DrawnMaps } from './drawn-maps.ts'

/** Document with the maps drawn from its strokes. */
export interface DocumentToPack {
  document: StudioDocument
  /** Maps by name of each layer with strokes. */
  drawn: ReadonlyMap<string, StrokeMaps>
}

/** Maps and heights drawn from the strokes of a layer. */
export interface StrokeMaps extends DrawnMaps {
  readonly heights: HeightMap
}

/** Encoded map, or pixels to encode. */
export type LayerMap = ImageFile | Pixels

/** Layer with the maps to write to a file. */
export interface PackedLayer {
  layer: StudioLayer
  /** Contains at least a normal map. */
  maps: { [Name in MapName]?: LayerMap }
  /** Drawn maps, which replace the layer's own. */
  drawn: MapName[]
  heightAmplitude?: number
}

/** Prepares layers for writing: adds the maps of their strokes, or flat normals if a layer has no normal map. */
export function packedLayers({ document: { layers, mapSize }, drawn }: DocumentToPack): PackedLayer[] {
  let flat: Pixels | undefined
  return layers.map((layer): PackedLayer => {
    const strokeMaps = drawn.get(layer.name)
    const { maps: made, heightAmplitude = layer.heightAmplitude } = strokeMaps
      ? mapsOf(strokeMaps, layer)
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
 * Occlusion and heights have half the side of the normals, as automatic wrinkles write them: only normals show how steep a crease
 * is. The layer's own height map has precedence.
 */
function mapsOf(
  { normal, occlusion, heights }: StrokeMaps,
  layer: StudioLayer,
): Pick<PackedLayer, 'heightAmplitude'> & { maps: { [Name in MapName]?: Pixels } } {
  const maps = {
    normal: withoutAlpha({ ...normal, channels: 4 }),
    occlusion: gray(halfSide(occlusion)),
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

/** A normal map of smooth skin. */
function flatNormal(size: number): Pixels {
  const data = new Uint8Array(3 * size ** 2).fill(128)
  for (let i = 2; i < data.length; i += 3) data[i] = 255
  return { width: size, height: size, channels: 3, data }
}
