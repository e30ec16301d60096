import type { GrayImage } from 'furrow'
import { type HeightMap, halfSide, heightLevels, type RgbaImage } from 'furrow/author'
import { encodePng, encodeRgbaNormalMap } from '../images/encode.ts'
import type { CheckedImage } from './checked-image.ts'
import type { LayerImages } from './embed.ts'
import type { MapName } from './map-slots.ts'

/** A layer of lines that was drawn. */
export interface DrawnLayer {
  name: string
  /** Of kind `detail`. */
  normal: RgbaImage
  /** Millimetres, of the size of the normals, as is the occlusion. */
  relief: HeightMap
  occlusion: GrayImage
  /** With half the side of the normals. */
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
 * Encodes the maps of a layer, each as an image of its own. All but the normals have half their side: only normals show how steep a crease is.
 *
 * @param hasHeight whether its lines are deep enough to move the surface.
 */
export async function encodeLayer(
  { name, normal, relief, occlusion, blood }: DrawnLayer,
  hasHeight: boolean,
): Promise<LayerMaps> {
  const { width, height } = normal
  const normalBytes = await encodeRgbaNormalMap(normal)
  const layer: LayerMaps = {
    name,
    kind: 'detail',
    normal: { name: `${name} normal`, mimeType: 'image/png', bytes: normalBytes, width, height },
    occlusion: await grayImage(`${name} occlusion`, halfSide(occlusion)),
    blood: await grayImage(`${name} blood`, blood),
  }
  if (!hasHeight) return layer
  const { levels, amplitude } = heightLevels(relief.data)
  const heights = await grayImage(`${name} height`, halfSide({ ...relief, data: levels }))
  return { ...layer, height: heights, heightAmplitude: amplitude }
}

async function grayImage(name: string, { width, height, data }: GrayImage): Promise<CheckedImage> {
  const bytes = await encodePng({ width, height, data, channels: 1 })
  return { name, mimeType: 'image/png', bytes, width, height }
}
