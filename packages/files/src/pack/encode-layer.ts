import type { GrayImage } from 'furrow'
import type { HeightMap, RgbaImage } from 'furrow/author'
import { halfSide, heightLevels } from 'furrow/internal'
import { encodeMap, encodeRgbaNormalMap } from '../images/encode.ts'
import type { Pixels } from '../images/pixels.ts'
import type { MapName } from '../wrinkles/map-slots.ts'
import { joinChannels } from '../wrinkles/shared-image.ts'
import type { CheckedImage } from './checked-image.ts'
import type { LayerImages } from './embed.ts'

/** Maps of a layer of lines, as pixels. */
export interface LayerToEncode {
  name: string
  /** Normal map of kind `detail`. */
  normal: RgbaImage
  /** Heights in millimetres. Same size as the normals and the occlusion. */
  heights: HeightMap
  occlusion: GrayImage
  /** Half the side of the normals. */
  blood: GrayImage
}

/** A layer with its maps as PNG. */
export interface LayerMaps extends Omit<LayerImages, MapName> {
  normal: CheckedImage
  occlusion: CheckedImage
  blood: CheckedImage
  height?: CheckedImage
}

/**
 * Encodes the maps of a layer. Normals keep full resolution, because they show how steep a crease is. Other maps have half the side.
 *
 * @param hasHeight whether the lines are deep enough to move the surface.
 * @param isShared whether occlusion and blood share one image, as in glTF files.
 */
export async function encodeLayer(
  { name, normal, heights, occlusion, blood }: LayerToEncode,
  hasHeight: boolean,
  isShared: boolean,
): Promise<LayerMaps> {
  const { width, height } = normal
  const normalBytes = await encodeRgbaNormalMap(normal)
  const open = halfSide(occlusion)
  const shared =
    isShared &&
    (await image(`${name} occlusion`, joinChannels([open, undefined, blood], open.width, open.height)))
  const layer: LayerMaps = {
    name,
    kind: 'detail',
    normal: { name: `${name} normal`, mimeType: 'image/png', bytes: normalBytes, width, height },
    occlusion: shared || (await image(`${name} occlusion`, { ...open, channels: 1 })),
    blood: shared || (await image(`${name} blood`, { ...blood, channels: 1 })),
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
