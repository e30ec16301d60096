import type { DataArrayTexture } from 'three'
import { isObject, wrongArgument } from '../../core/argument.ts'
import type { Bounds } from '../../core/bounds.ts'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { checkImage } from '../../core/image.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage } from '../../core/types.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { MAP_KINDS } from '../../runtime/maps/layer-maps.ts'
import { type LayerMaps, listTextures, type WrinkleTextures } from '../material/wrinkle-textures.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { compressed } from './compressed.ts'
import { channelsOf, firstLevel } from './mip-chain.ts'
import { changesOf } from './texture-changes.ts'
import { unknownLayer } from './unknown-layer.ts'

/** New images for the maps of a layer, see `Layer`. Each image must have the size of the image that it replaces. */
export interface LayerImages {
  normal?: RgbaImage
  baseColor?: RgbaImage
  roughness?: GrayImage
  occlusion?: GrayImage
  blood?: GrayImage
  onset?: GrayImage
}

type Kind = (typeof MAP_KINDS)[number]

/**
 * Replaces a region of the maps of a layer from the next frame on. The change affects all `Wrinkles` that share the textures. Uploads only the
 * region and its mipmaps, so it can be called for every movement of a brush. The GPU regenerates all mipmaps if the region covers a quarter of
 * the map or more, or if the width or height of the map is not a power of two. That takes about as long as uploading a complete map.
 *
 * @param wrinkles wrinkles of the face.
 * @param name name of the layer.
 * @param images new maps in full size. Their texels in the region are copied. Omitted maps stay unchanged.
 * @param region rectangle of texels to replace in each map: columns `x0` to `x1 - 1`, and rows `y0` to `y1 - 1` from the top. Default: the
 *   complete map.
 * @throws FurrowError if the layer or map is unknown, an image is malformed or differs in size, or the region is out of bounds. Also throws if
 *   the maps are in KTX 2 textures, or the wrinkles were disposed of. Nothing then changes.
 */
export function updateLayer(
  wrinkles: WrinklesBase,
  name: string,
  images: LayerImages,
  region?: Readonly<Bounds>,
): void {
  checkWrinkles(wrinkles, WHO)
  const mesh = meshOf(wrinkles)
  mesh.checkInUse(WHO)
  const { textures } = mesh.shaderInputs
  const index = textures.layers.findIndex((layer) => layer.name === name)
  if (index < 0) throw unknownLayer(name, textures.layers, WHO)
  const updates = kindsOf(images).map((kind) => checkUpdate(textures, index, kind, images[kind], region))
  for (const { kind, maps, image, bounds } of updates) {
    const present = copyRegion(image, maps, index, bounds)
    if (present) textures.layers[index] = { ...textures.layers[index], [kind]: present }
  }
  textures.version++
  textures.upload = uploadOf(textures)
}

const WHO = 'updateLayer'

interface Update {
  kind: Kind
  maps: LayerMaps
  image: RgbaImage | GrayImage
  bounds: Readonly<Bounds>
}

function kindsOf(images: LayerImages): Kind[] {
  const given = isObject(images) ? Object.entries(images) : []
  const names = given.flatMap(([name, image]) => (image === undefined ? [] : name))
  if (names.length > 0 && names.every((name) => MAP_KINDS.includes(name as Kind))) return names as Kind[]
  throw wrongArgument(WHO, 'images', isObject(images) ? names.join(', ') : images, MAP_KINDS.join(', '))
}

/** @throws FurrowError if the image cannot replace the layer's map. */
function checkUpdate(
  textures: WrinkleTextures,
  index: number,
  kind: Kind,
  image: RgbaImage | GrayImage | undefined,
  region: Readonly<Bounds> | undefined,
): Update {
  const layer = textures.layers[index]
  const who = `${WHO} layer "${layer.name}" ${kind}`
  const maps = kind === 'normal' ? textures.normals : textures.values[kind]
  const present: RgbaImage | GrayImage | ArraySlice | undefined = layer[kind]
  if (!maps || !present) throw missing(who, layer)
  if (isSlice(present)) throw compressed(who)
  if (!isObject(image)) throw wrongArgument(who, 'image', image, 'an image')
  const { width, height } = present
  checkImage(image, kind === 'normal' || kind === 'baseColor' ? 'RGBA' : 'gray', who)
  if (image.width !== width || image.height !== height) {
    throw wrongArgument(who, 'size', `${image.width} x ${image.height}`, `${width} x ${height}`)
  }
  const bounds = region ?? { x0: 0, y0: 0, x1: width, y1: height }
  checkRegion(bounds, width, height, who)
  return { kind, maps, image, bounds }
}

function checkRegion(region: Readonly<Bounds>, width: number, height: number, who: string): void {
  const { x0, y0, x1, y1 } = region
  const areIntegers = [x0, y0, x1, y1].every(Number.isInteger)
  if (areIntegers && x0 >= 0 && y0 >= 0 && x0 <= x1 && y0 <= y1 && x1 <= width && y1 <= height) return
  const limit = `0 <= x0 <= x1 <= ${width}, 0 <= y0 <= y1 <= ${height}, in whole texels`
  throw wrongArgument(who, 'region', region, limit)
}

/**
 * Copies a rectangle of an image into a layer's slice of a texture array, or into a channel of the slice.
 *
 * @returns the complete slice as an image, from which the wrinkle mode `paper` makes its own texture array. Undefined if the slice also holds
 *   another map.
 */
function copyRegion(
  { width, height, data }: RgbaImage | GrayImage,
  { texture, slices, channel }: LayerMaps,
  layer: number,
  bounds: Readonly<Bounds>,
): RgbaImage | GrayImage | undefined {
  const slice = slices[layer]!
  const level = firstLevel(texture as DataArrayTexture, slice)
  const channels = data.length / (width * height)
  const stride = channelsOf(level)
  for (let y = bounds.y0; y < bounds.y1; y++) {
    const [start, end] = [y * width + bounds.x0, y * width + bounds.x1]
    if (stride === channels) level.data.set(data.subarray(start * channels, end * channels), start * channels)
    else for (let i = start; i < end; i++) level.data[stride * i + channel] = data[i]
  }
  changesOf(texture as DataArrayTexture).add(slice, bounds)
  return stride === channels ? { width, height, data: level.data } : undefined
}

function uploadOf(textures: WrinkleTextures): WrinkleTextures['upload'] {
  const changes = listTextures(textures).map((texture) => changesOf(texture as DataArrayTexture))
  return (renderer) => {
    for (let i = 0; i < changes.length; i++) changes[i].upload(renderer)
  }
}

function missing(who: string, layer: Layer<ArraySlice>): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'the layer has no such map',
    limit: MAP_KINDS.filter((kind) => layer[kind]).join(', '),
    remedy: 'create new wrinkles from layers with this map',
  })
}
