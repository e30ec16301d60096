import { BufferViewWriter } from '../gltf/buffer-view-writer.ts'
import type { Pixels } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import type { FaceToImport } from './face-maps.ts'

/** Gives the material of a face a normal map. Changes the file in place. */
export function addNormalMap({ glb, target }: FaceToImport, pixels: Pixels): void {
  const views = new BufferViewWriter(glb)
  const { json } = glb
  json.images ??= []
  json.textures ??= []
  const view = views.add(encodePortablePng(pixels))
  views.finish()
  const source = json.images.push({ name: 'neutral normal', mimeType: 'image/png', bufferView: view }) - 1
  const index = json.textures.push({ name: 'neutral normal', source }) - 1
  json.materials![target.material].normalTexture = { index }
}
