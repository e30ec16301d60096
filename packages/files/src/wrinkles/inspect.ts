import type { GrayImage, WrinkleDriver } from 'furrow'
import type { TextureReference } from 'furrow/internal'
import { imageOf } from '../gltf/texture-image.ts'
import { pixelsOf, sizeOf } from '../gltf/texture-pixels.ts'
import { channelOf } from '../images/pixels.ts'
import { MAP_SLOTS, type MapName } from './map-slots.ts'
import {
  areaSizes,
  areaSliceSizes,
  type GpuSizes,
  influenceMapBytes,
  mapSizes,
  NO_SIZES,
  sumSizes,
} from './sizes.ts'
import { strokesBytes, strokesIn } from './strokes.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

/** Size of one map of one layer. */
export interface MapReport {
  map: MapName
  texture: number
  /** Slice of a KTX 2 array. `bytes` is then the size of the whole array. */
  slice?: number
  mimeType: string
  width: number
  height: number
  bytes: number
  gpu: GpuSizes
}

export interface LayerReport {
  name: string
  kind: string
  normalScale: number
  maps: MapReport[]
}

export interface AreaReport {
  name: string
  layer: string
  texture: number
  /** Slice of a KTX 2 array. */
  slice?: number
  channel: string
  combine: string
  activation: number
  width: number
  height: number
  /** Fraction of texels with a weight above 0, 0..1. */
  coverage: number
  /** Largest weight, 0..1. */
  largest: number
}

/** Report on the wrinkles of a material: contents, file size and GPU memory. */
export interface Inspection {
  material?: string
  fileBytes: number
  /** Bytes of the images of maps and areas, as encoded in the file. A shared image counts once. */
  imageBytes: number
  /** GPU memory of maps and areas. All faces from this file share it. */
  gpu: GpuSizes
  /** GPU memory of the influence map, bytes. Each face has its own influence map. */
  influenceMapBytes: number
  layers: LayerReport[]
  areas: AreaReport[]
  drivers: WrinkleDriver[]
  /** Number of strokes (wrinkle lines), and the bytes that they take in the file. */
  strokes: { count: number; bytes: number }
}

/** Measures the wrinkles of a material. Throws FurrowError if an image is missing or cannot be decoded. */
export async function inspectWrinkles(file: WrinkledFile, who: string): Promise<Inspection> {
  const { glb, maps } = file
  const layers = await Promise.all(
    maps.layers.map(async (layer): Promise<LayerReport> => {
      const slots = MAP_SLOTS.flatMap(([map, slot]) => (layer[slot] ? [{ map, info: layer[slot] }] : []))
      const reports = slots.map(({ map, info }) => measureMap(file, map, info, who))
      const { name, kind, normalTexture } = layer
      return { name, kind, normalScale: normalTexture.scale, maps: await Promise.all(reports) }
    }),
  )
  const areas: AreaReport[] = []
  for (const [i, { name, layer, texture, channel, combine, activation }] of maps.areas.entries()) {
    const weights = await weightsOf(file, i, who)
    areas.push({
      name,
      layer: maps.layers[layer].name,
      texture: texture.index,
      ...(texture.slice !== undefined && { slice: texture.slice }),
      channel: 'RGBA'[channel],
      combine,
      activation,
      width: weights.width,
      height: weights.height,
      ...coverageOf(weights),
    })
  }
  const textures = new Map(
    layers.flatMap(({ maps }) =>
      maps.map(({ texture, slice, gpu }) => [`${texture} ${slice}`, gpu] as const),
    ),
  )
  const images = new Set([...layers.flatMap(({ maps }) => maps), ...areas].map(({ texture }) => texture))
  const { strokes } = strokesIn(file, who)
  return {
    material: glb.json.materials![file.material].name,
    fileBytes: glb.fileBytes,
    imageBytes: [...images].reduce((sum, index) => sum + imageOf(glb, index, who).bytes.length, 0),
    gpu: sumSizes([...textures.values(), ...areaGpuSizes(areas)]),
    influenceMapBytes: influenceMapBytes(areas[0].width, areas[0].height, layers.length),
    layers,
    areas,
    drivers: maps.drivers,
    strokes: { count: strokes?.strokes.length ?? 0, bytes: strokesBytes(strokes) },
  }
}

/** Decodes the weights of one area, with the width and height of its image. */
export async function weightsOf({ glb, maps }: WrinkledFile, area: number, who: string): Promise<GrayImage> {
  const { texture, channel } = maps.areas[area]
  return channelOf(await pixelsOf(glb, texture, who), channel)
}

async function measureMap(
  { glb }: WrinkledFile,
  map: MapName,
  { index, slice }: TextureReference,
  who: string,
): Promise<MapReport> {
  const image = imageOf(glb, index, who)
  const { width, height } = await sizeOf(glb, index, who)
  const { mimeType, bytes } = image
  return {
    map,
    texture: index,
    ...(slice !== undefined && { slice }),
    mimeType,
    width,
    height,
    bytes: bytes.length,
    // Height maps are not counted, because they are uploaded only if a page turns relief on.
    gpu: map === 'height' ? NO_SIZES : mapSizes(width, height),
  }
}

/**
 * Computes the GPU memory of each slice with areas. An area in a PNG image gets its own slice on the GPU. Areas in a
 * KTX 2 array share slices, up to four in one.
 */
function areaGpuSizes(areas: readonly AreaReport[]): GpuSizes[] {
  const slices = new Map(areas.map((area) => [`${area.texture} ${area.slice}`, area]))
  if (areas[0].slice !== undefined) {
    return [...slices.values()].map(({ width, height }) => areaSliceSizes(width, height))
  }
  return areas.map(({ width, height }) => areaSizes(width, height))
}

function coverageOf({ data }: GrayImage): { coverage: number; largest: number } {
  let [visible, largest] = [0, 0]
  for (const weight of data) {
    if (weight > 0) visible++
    if (weight > largest) largest = weight
  }
  return { coverage: visible / data.length, largest: largest / 255 }
}
