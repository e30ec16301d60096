import { WrinkleLoaderPlugin } from 'furrow/three'
import type { WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

/** An address of our own, or a file of the visitor's. */
export type AvatarFile = string | File

/** How the making of wrinkles is followed. */
export interface Making {
  progress?: (done: number, total: number) => void
}

/** Texels of the maps that are made: the face does not fill the screen. */
const SIZE = 1024

/** Loads a face from an address or from the visitor's own file, which is read here and sent nowhere. */
export async function loadAvatar(file: AvatarFile, renderer: WebGLRenderer, making?: Making): Promise<GLTF> {
  const bytes = await (typeof file === 'string' ? read(file) : file.arrayBuffer())
  const loader = new GLTFLoader()
  loader.register((parser) => new WrinkleLoaderPlugin(parser, { auto: { size: SIZE, age: 50, ...making } }))
  await addDecoders(loader, renderer, bytes)
  return loader.parseAsync(bytes, '')
}

async function read(address: string): Promise<ArrayBuffer> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${address} answers ${response.status}`)
  return response.arrayBuffer()
}

/** Fetches the decoders that the file names, and no others. */
async function addDecoders(loader: GLTFLoader, renderer: WebGLRenderer, bytes: ArrayBuffer): Promise<void> {
  // The JSON comes first in a .glb (glTF 2.0, section 4.4), and is all of a .gltf.
  const isBinary = new TextDecoder().decode(bytes.slice(0, 4)) === 'glTF'
  const end = isBinary ? 20 + new DataView(bytes).getUint32(12, true) : bytes.byteLength
  const json = new TextDecoder().decode(bytes.slice(isBinary ? 20 : 0, end))
  const names = (extension: string) => json.includes(`"${extension}"`)
  if (names('EXT_meshopt_compression') || names('KHR_meshopt_compression')) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js')
    loader.setMeshoptDecoder(MeshoptDecoder)
  }
  if (names('KHR_draco_mesh_compression')) {
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js')
    loader.setDRACOLoader(new DRACOLoader())
  }
  if (names('KHR_texture_basisu')) {
    const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js')
    loader.setKTX2Loader(new KTX2Loader().detectSupport(renderer))
  }
}
