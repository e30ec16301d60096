import type { GrayImage } from 'furrow'
import type { HeightMap, RgbaImage } from 'furrow/author'
import { halfSide, heightLevels } from 'furrow/internal'
import { encodeMap, encodeRgbaNormalMap } from '../images/encode.ts'
import type { Pixels } from '../images/pixels.ts'
import type { MapName } from '../wrinkles/map-slots.ts'
import { joinChannels } from '../wrinkles/shared-image.ts'
import type { CheckedImage } from './checked-image.ts'
import type { LayerImages } from './embed.ts'

/** Decoded maps of a layer that was drawn from wrinkle lines. */
export interface LayerToEncode {
  name: string
  /** Normal map of kind `detail`: normals on top of the skin's own normal map. */
  normal: RgbaImage
  /** Heights in millimetres, with the size of the normals and the occlusion. */
  heights: HeightMap
  occlusion: GrayImage
  /** Blood map with half the width and height of the normals. */
  blood: GrayImage
  /** Onset map (activation at which wrinkles begin to show) with the size of the normals. */
  onset?: GrayImage
}

/** A layer with its maps as PNG. */
export interface LayerMaps extends Omit<LayerImages, MapName> {
  normal: CheckedImage
  occlusion: CheckedImage
  blood: CheckedImage
  onset?: CheckedImage
  height?: CheckedImage
}

/**
 * Encodes the maps of a layer as PNG. Only normals keep full resolution, because they show how steep a crease is. Other
 * maps get half the width and height.
 *
 * @param hasHeight whether to store heights. False if the lines are too shallow to move the surface.
 * @param isShared whether occlusion, blood and onset share one image, as in glTF files.
 */
export async function encodeLayer(
  { name, normal, heights, occlusion, blood, onset }: LayerToEncode,
  hasHeight: boolean,
  isShared: boolean,
): Promise<LayerMaps> {
  const { width, height } = normal
  const normalBytes = await encodeRgbaNormalMap(normal)
  const open = halfSide(occlusion)
  const begin = onset && halfSide(onset)
  const shared =
    isShared &&
    (await image(`${name} occlusion`, joinChannels([open, begin, blood], open.width, open.height)))
  const layer: LayerMaps = {
    name,
    kind: 'detail',
    normal: { name: `${name} normal`, mimeType: 'image/png', bytes: normalBytes, width, height },
    occlusion: shared || (await image(`${name} occlusion`, { ...open, channels: 1 })),
    blood: shared || (await image(`${name} blood`, { ...blood, channels: 1 })),
    ...(begin && { onset: shared || (await image(`${name} onset`, { ...begin, channels: 1 })) }),
  }
  if (!hasHeight) return layer
  const { levels, amplitude } = heightLevels(heights.data)
  const encoded = await image(`${name} height`, { ...halfSide({ ...heights, data: levels }), channels: 1 })
  return { ...layer, height: encoded, heightAmplitude: amplitude }
}

async function image(name: string, pixels: Pixels): Promise<CheckedImage> {
  const { width, height } = pixels
  return { name, mimeType: 'image/png', bytes: await encodeMap(pixels), width, height }
}
