import sharp from 'sharp'
import { CompressedArrayTexture, CompressedTexture, RGBA_BPTC_Format } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { vi } from 'vitest'
import { decodeArray } from '../../../packages/files/src/ktx2/ktx2.ts'

/** Decodes an image like a browser, but with sharp. */
async function createImageBitmap(blob: Blob) {
  const bytes = new Uint8Array(await blob.arrayBuffer())
  const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true }).toColourspace('srgb').ensureAlpha()
  const { data, info } = await image.raw().toBuffer({ resolveWithObject: true })
  return { width: info.width, height: info.height, data: new Uint8Array(data), close() {} }
}

/** Fake transcoder. Its textures have the right kind and size, but no contents. */
const ktx2Loader = {
  async loadAsync(url: string): Promise<CompressedTexture> {
    const bytes = new Uint8Array(await (await fetch(url)).arrayBuffer())
    const { width, height, layers } = await decodeArray(bytes)
    const mipmaps = [{ data: new Uint8Array(16), width, height }]
    return layers.length > 1
      ? new CompressedArrayTexture(mipmaps, width, height, layers.length, RGBA_BPTC_Format)
      : new CompressedTexture(mipmaps, width, height, RGBA_BPTC_Format)
  },
}

/** Replaces the functions of browsers that three.js's GLTFLoader needs. */
export function fakeBrowser(): void {
  vi.stubGlobal('self', globalThis)
  vi.stubGlobal('createImageBitmap', createImageBitmap)
}

/** Loads a file with three.js's GLTFLoader in Node. */
export async function loadInNode(bytes: Uint8Array): Promise<GLTF> {
  fakeBrowser()
  const loader = new GLTFLoader().setKTX2Loader(ktx2Loader as unknown as KTX2Loader)
  return loader.parseAsync(new Uint8Array(bytes).buffer, '')
}
