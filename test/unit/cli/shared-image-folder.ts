import { noise } from '../../noise.ts'
import { faceBytes, grayPng, type Workshop } from './workshop.ts'

/** Width and height of the maps in texels. */
export const SIZE = 16

/** Indices of the texels of a map. */
export const texels = Array.from({ length: SIZE * SIZE }, (_, i) => i)

/** Value of a texel of the occlusion map. */
export const OCCLUSION = (i: number) => 255 - (i % 100)

/** Makes a gray PNG file. `value` returns a texel, 0..255. */
export const gray = (value: (i: number) => number, size = SIZE) =>
  grayPng(
    Uint8Array.from({ length: size * size }, (_, i) => value(i)),
    size,
  )

/**
 * Writes a wrinkle folder with the layers `up` and `down`. Both have a map of the same kind, and `up` also has occlusion. In a packed file, the
 * two maps of `up` share an image.
 *
 * @param value returns a texel of the map, 0..255.
 * @param layers entries of `wrinkles.json`.
 * @returns path of the folder.
 */
export async function writeSharedFolder(
  shop: Workshop,
  name: string,
  kind: 'blood' | 'onset',
  value: (i: number) => number,
  layers: object[],
): Promise<string> {
  shop.write(`${name}/face.glb`, await faceBytes())
  for (const layer of ['up', 'down']) {
    shop.write(`${name}/layers/${layer}/normal.png`, await noise(1, 3, SIZE))
    shop.write(`${name}/layers/${layer}/${kind}.png`, await gray(value))
  }
  shop.write(`${name}/layers/up/occlusion.png`, await gray(OCCLUSION))
  shop.write(`${name}/areas/nose.png`, await gray((i) => i))
  shop.json(`${name}/wrinkles.json`, { version: 1, layers })
  return shop.path(name)
}
