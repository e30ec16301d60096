import { FurrowError, type GrayImage, type TextureReference, type WrinkleDriver } from 'furrow'
import sharp from 'sharp'
import { firstLine } from '../images.ts'
import { channelOf } from './map-images.ts'
import { pixelsOf } from './pixels.ts'
import { areaSizes, areaSliceSizes, type GpuSizes, influenceMapBytes, mapSizes, sumSizes } from './sizes.ts'
import { imageOf, isKtx2, MAP_SLOTS, type TextureImage, type WrinkledFile } from './wrinkled-file.ts'

/** One map of one layer. */
export interface MapReport {
  map: 'normal' | 'baseColor' | 'roughness' | 'occlusion' | 'height'
  texture: number
  /** Of a KTX 2 array, whose bytes in the file all slices share. */
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
  /** Of a KTX 2 array. */
  slice?: number
  channel: string
  combine: string
  activation: number
  width: number
  height: number
  /** Share of the texels where it shows at all, 0..1. */
  coverage: number
  /** Its largest weight, 0..1. */
  largest: number
}

/** What a file holds in wrinkles. */
export interface Report {
  material?: string
  fileBytes: number
  /** Bytes of the wrinkles' images in the file, each counted once. */
  imageBytes: number
  /** Maps and areas, which all faces with them share. */
  gpu: GpuSizes
  /** What each face needs besides. */
  influenceMapBytes: number
  layers: LayerReport[]
  areas: AreaReport[]
  drivers: WrinkleDriver[]
}

/** Measures the wrinkles of a file. Throws FurrowError where an image is missing or cannot be read. */
export async function inspectWrinkles(file: WrinkledFile, who: string): Promise<Report> {
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
  return {
    material: glb.json.materials![file.material].name,
    fileBytes: glb.fileBytes,
    imageBytes: [...images].reduce((sum, index) => sum + imageOf(glb, index, who).bytes.length, 0),
    gpu: sumSizes([...textures.values(), ...gpuOfAreas(areas)]),
    influenceMapBytes: influenceMapBytes(areas[0].width, areas[0].height, layers.length),
    layers,
    areas,
    drivers: maps.drivers,
  }
}

/** The weights of one area as they are in its image. */
export async function weightsOf({ glb, maps }: WrinkledFile, area: number, who: string): Promise<GrayImage> {
  const { texture, channel } = maps.areas[area]
  return channelOf(await pixelsOf(glb, texture, who), channel)
}

/** Size of an image by its header. */
export async function sizeOf(image: TextureImage, who: string): Promise<{ width: number; height: number }> {
  const { bytes, name } = image
  if (isKtx2(image) && bytes.length >= 28) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    return { width: view.getUint32(20, true), height: Math.max(1, view.getUint32(24, true)) }
  }
  try {
    const { width, height } = await sharp(bytes).metadata()
    return { width, height }
  } catch (error) {
    throw new FurrowError({
      who,
      what: `the image "${name}" cannot be read (${firstLine(error)})`,
      remedy: 'export the file again',
    })
  }
}

async function measureMap(
  { glb }: WrinkledFile,
  map: MapReport['map'],
  { index, slice }: TextureReference,
  who: string,
): Promise<MapReport> {
  const image = imageOf(glb, index, who)
  const { width, height } = await sizeOf(image, who)
  const { mimeType, bytes } = image
  const place = { map, texture: index, ...(slice !== undefined && { slice }) }
  return { ...place, mimeType, width, height, bytes: bytes.length, gpu: mapSizes(width, height) }
}

/** Images become one slice for each area; an array stays as it is, several areas to a slice. */
function gpuOfAreas(areas: readonly AreaReport[]): GpuSizes[] {
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
