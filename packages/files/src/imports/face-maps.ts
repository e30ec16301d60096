import type { Glb } from '../gltf/glb.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import type { Pixels } from '../images/pixels.ts'
import type { Target } from '../json/target-names.ts'
import { scaledTo } from './source-image.ts'

/** The face that gets the wrinkles. */
export interface FaceToImport {
  glb: Glb
  /** Path of the file, for errors. */
  path: string
  target: Target
}

/** Decodes the normal map of the face's material. Returns undefined if it has none. */
export function faceNormalMap(face: FaceToImport, size: number, who: string): Promise<Pixels | undefined> {
  return textureOf(face, materialOf(face).normalTexture, size, who)
}

/** Decodes the base colour of the face's material. Returns undefined if it has no texture. */
export function faceColours(face: FaceToImport, size: number, who: string): Promise<Pixels | undefined> {
  return textureOf(face, materialOf(face).pbrMetallicRoughness?.baseColorTexture, size, who)
}

function materialOf({ glb, target }: FaceToImport) {
  return glb.json.materials![target.material]
}

async function textureOf(
  { glb }: FaceToImport,
  info: { index: number } | undefined,
  size: number,
  who: string,
): Promise<Pixels | undefined> {
  return info && scaledTo(await pixelsOf(glb, { index: info.index }, who), size)
}
