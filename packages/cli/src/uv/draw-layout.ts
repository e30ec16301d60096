import { drawUvLayout } from 'furrow/internal'
import { type FoundSkin, type Glb, pixelsOf, withCommandErrors } from 'furrow-files'
import sharp from 'sharp'

/**
 * Draws the UV layout of the skin. Draws it over the base colour if that has the same texture coordinates as the
 * wrinkles.
 *
 * @param size width and height of the result, texels.
 * @returns RGBA bytes.
 * @throws FurrowError if the base colour cannot be decoded, or if hundreds of triangles overlap.
 */
export async function drawSkinLayout(
  glb: Glb,
  { skin, material }: FoundSkin,
  size: number,
  who: string,
): Promise<Uint8Array> {
  const base = await baseColour(glb, material, size, who)
  const drawn = withCommandErrors(who, () =>
    drawUvLayout(skin, size, base && { base: { width: size, height: size, data: base } }),
  )
  return drawn.data
}

async function baseColour(
  glb: Glb,
  index: number,
  size: number,
  who: string,
): Promise<Uint8Array | undefined> {
  const { pbrMetallicRoughness, normalTexture } = glb.json.materials?.[index] ?? {}
  const texture = pbrMetallicRoughness?.baseColorTexture
  const isSame = JSON.stringify(layoutOf(texture)) === JSON.stringify(layoutOf(normalTexture ?? texture))
  if (!texture || !isSame) return undefined
  const { width, height, channels, data } = await pixelsOf(glb, texture, who)
  const image = sharp(data, { raw: { width, height, channels } })
    .removeAlpha()
    .resize(size, size, { fit: 'fill' })
  return image.toColourspace('srgb').ensureAlpha().raw().toBuffer()
}

function layoutOf(info: { texCoord?: number; extensions?: Record<string, unknown> } = {}) {
  return [info.texCoord ?? 0, info.extensions?.KHR_texture_transform]
}
