import type { RgbaImage } from '../types.ts'
import { toByte } from './normal-byte.ts'

/**
 * Scales x and y of a normal map and renormalises.
 *
 * @returns `image` itself if the scale is 1, otherwise a new image.
 */
export function scaleNormals(image: RgbaImage, scale: number): RgbaImage {
  if (scale === 1) return image
  const data = image.data.slice()
  for (let i = 0; i < data.length; i += 4) {
    const [x, y, z] = [0, 1, 2].map((c) => (data[i + c] / 255) * 2 - 1)
    const length = Math.sqrt((x * x + y * y) * scale * scale + z * z)
    const normal = [(x * scale) / length, (y * scale) / length, z / length]
    for (let c = 0; c < 3; c++) data[i + c] = toByte(normal[c])
  }
  return { ...image, data }
}
