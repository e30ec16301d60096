import {
  HalfFloatType,
  type MeshStandardMaterial,
  type Texture,
  type TextureDataType,
  UnsignedByteType,
} from 'three'
import type { WrinkleMaterial } from '../wrinkle-material.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'

/**
 * The least roughness at which steps of 8 bits in a normal map change a picture by two steps of 8 bits at most: measured on a face with maps of
 * 1024 x 1024 texels in pictures of 400 x 400, where 0.35 changes it by four.
 */
const ROUGH = 0.5

/** The same of the factor of a roughness map, by which skin is smoother than its factor: there 0.6 changes it by four. */
const ROUGH_WITH_MAP = 0.7

/** The largest amplitude of blood of which steps of 8 bits change a picture by two steps at most: 1.5 changes it by three. */
const FLUSHED = 1

/** The numbers of a composed map: half floats where the base map has them, and where steps of bytes would be seen. */
export function composedType(
  base: Texture,
  material: WrinkleMaterial,
  { layers }: WrinkleTextures,
): TextureDataType {
  const isFlushed = layers.some(({ blood, bloodAmplitude = 0 }) => blood && bloodAmplitude > FLUSHED)
  return isOfBytes(base, material) && !isFlushed ? UnsignedByteType : HalfFloatType
}

/** Whether bytes do for normals. */
export function isOfBytes(base: Texture, material: WrinkleMaterial): boolean {
  return base.type !== HalfFloatType && !isGlossy(material)
}

/** Other models of light have no roughness. */
function isGlossy(material: WrinkleMaterial): boolean {
  const { roughness = 1, roughnessMap } = material as Partial<MeshStandardMaterial>
  const { normalScale } = material
  // Measured too: what a step changes grows with the slopes and, like the brightness of highlights, with the inverse fourth power of roughness.
  const steepness = Math.max(Math.abs(normalScale.x), Math.abs(normalScale.y)) ** 0.25
  return roughness < (roughnessMap ? ROUGH_WITH_MAP : ROUGH) * steepness
}

export function bytesOfTexel(type: TextureDataType): number {
  return type === HalfFloatType ? 8 : 4
}
