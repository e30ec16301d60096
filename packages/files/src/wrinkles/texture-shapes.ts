import { FurrowError } from 'furrow'
import { drawnTextures, type TextureShape, WRINKLE_MAPS, type WrinkleMaps } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import { imageOf, isKtx2, ktx2HeaderOf } from '../gltf/texture-image.ts'
import { arrayOf, pixelsOf } from '../gltf/texture-pixels.ts'

/**
 * Decodes all textures that a loader would decode, and returns their shapes. Headers would not suffice, because they do
 * not show damage.
 *
 * @throws FurrowError for the first texture that cannot be decoded.
 */
export async function readShapes(glb: Glb, maps: WrinkleMaps): Promise<Map<number, TextureShape>> {
  const shapes = new Map<number, TextureShape>()
  for (const index of drawnTextures(maps)) shapes.set(index, await readShape(glb, index))
  return shapes
}

async function readShape(glb: Glb, index: number): Promise<TextureShape> {
  const header = ktx2HeaderOf(glb, index, WRINKLE_MAPS)
  if (header) {
    await arrayOf(glb, index, WRINKLE_MAPS)
    return header
  }
  if (isKtx2(imageOf(glb, index, WRINKLE_MAPS))) {
    throw new FurrowError({
      who: WRINKLE_MAPS,
      problem: `texture ${index} has a KTX 2 image without KHR_texture_basisu`,
      remedy: 'pack the file again',
    })
  }
  const { width, height } = await pixelsOf(glb, { index }, WRINKLE_MAPS)
  return { width, height }
}
