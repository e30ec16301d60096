import { extendLoader } from 'furrow/three'
import type { WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

/** URL of an avatar, or a local file that the visitor chose. */
export type AvatarFile = string | File

export interface AvatarOptions {
  progress?: (done: number, total: number) => void
}

/** Size of generated maps, texels. Larger maps would not be visible, because the face does not fill the screen. */
const SIZE = 1024

/** Loads an avatar. A local file is not uploaded. Generates wrinkles if the file has none. */
export async function loadAvatar(
  file: AvatarFile,
  renderer: WebGLRenderer,
  options?: AvatarOptions,
): Promise<GLTF> {
  const bytes = await (typeof file === 'string' ? read(file) : file.arrayBuffer())
  const loader = new GLTFLoader()
  extendLoader(loader, { auto: { size: SIZE, age: 50, ...options } })
  await addDecoders(loader, renderer, bytes)
  return loader.parseAsync(bytes, '')
}

async function read(address: string): Promise<ArrayBuffer> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${address}: HTTP status ${response.status}`)
  return response.arrayBuffer()
}

async function addDecoders(loader: GLTFLoader, renderer: WebGLRenderer, bytes: ArrayBuffer): Promise<void> {
  // The JSON is the first chunk of a .glb (glTF 2.0, section 4.4), or the whole .gltf.
  const isBinary = new TextDecoder().decode(bytes.slice(0, 4)) === 'glTF'
  const end = isBinary ? 20 + new DataView(bytes).getUint32(12, true) : bytes.byteLength
  const json = new TextDecoder().decode(bytes.slice(isBinary ? 20 : 0, end))
  const uses = (extension: string) => json.includes(`"${extension}"`)
  if (uses('EXT_meshopt_compression') || uses('KHR_meshopt_compression')) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js')
    loader.setMeshoptDecoder(MeshoptDecoder)
  }
  if (uses('KHR_draco_mesh_compression')) {
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js')
    loader.setDRACOLoader(new DRACOLoader())
  }
  if (uses('KHR_texture_basisu')) {
    const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js')
    loader.setKTX2Loader(new KTX2Loader().detectSupport(renderer))
  }
}
