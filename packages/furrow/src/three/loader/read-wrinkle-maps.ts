import type { Mesh, Object3D } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import type { GltfSource } from '../../runtime/file/gltf-source.ts'
import {
  extensionOf,
  type FileWrinkles,
  type OnFault,
  wrinkleReader,
} from '../../runtime/file/read-wrinkles.ts'
import { surfaceOf } from '../material/surface.ts'
import type { RaisedLayer } from '../relief/raised-layer.ts'
import { readImageBytes } from './image-bytes.ts'

/** A face of a file: meshes that have one material with the extension. */
export interface FileFace {
  /** The primitives of a glTF mesh. The first one drives. */
  meshes: [Mesh, ...Mesh[]]
  /** Index of the material in the file. */
  material: number
}

/** The wrinkles of one face in a file. */
export interface LoadedWrinkles extends FileWrinkles {
  /** The meshes of the face, which have one material: the primitives of a glTF mesh. The first one drives. */
  meshes: [Mesh, ...Mesh[]]
}

type Parser = GLTF['parser']

/**
 * Reads FURROW_wrinkle_maps from a file that three.js's `GLTFLoader` has loaded, as plain data for any renderer. `WrinkleLoaderPlugin`
 * calls it by itself. three-vrm replaces the materials of a VRM 0: for these, register `WrinkleLoaderPlugin` too.
 *
 * @param gltf what the loader returned.
 * @param parser the loader's, `gltf.parser` by default.
 * @returns one entry for each face that has the extension.
 * @throws FurrowError when the extension is malformed or an image cannot be read.
 */
export async function readWrinkleMaps(gltf: GLTF, parser: Parser = gltf.parser): Promise<LoadedWrinkles[]> {
  const readMaterial = materialReader(parser)
  const found: LoadedWrinkles[] = []
  for (const { meshes, material } of wrinkledFaces(gltf, parser)) {
    const read = await readMaterial(material)
    await Promise.all(read.set.layers.map(decodeHeight))
    found.push({ meshes, ...read })
  }
  return found
}

async function decodeHeight(layer: RaisedLayer): Promise<void> {
  if (!layer.readHeight) return
  layer.height = await layer.readHeight()
  delete layer.readHeight
}

/** The faces whose materials have the extension, malformed or not. */
export function wrinkledFaces(gltf: GLTF, parser: Parser): FileFace[] {
  return facesOf(gltf, parser).flatMap((meshes) => {
    // The loader clones materials; the clones are of the same material in the file.
    const material = parser.associations.get(surfaceOf(meshes[0]))?.materials
    if (material === undefined || extensionOf(material, parser) === undefined) return []
    return { meshes, material }
  })
}

/** `wrinkleReader` of a file that `GLTFLoader` loads. */
export function materialReader(
  parser: Parser,
  onFault?: OnFault,
): (material: number) => Promise<FileWrinkles> {
  return wrinkleReader(fileOf(parser), onFault)
}

/** Few files have KTX 2 images: the code for these is fetched when one appears. */
function fileOf(parser: Parser): GltfSource {
  return {
    json: parser.json,
    readBytes: (image, who) => readImageBytes(parser, image, who),
    get prefersArrays() {
      return Boolean((parser.options as { ktx2Loader?: unknown }).ktx2Loader)
    },
    fetchArrays: async () => (await import('./ktx2.ts')).arraysOf(parser),
  }
}

/** Groups meshes by face: the primitives of a glTF mesh that have one material are one face. */
export function facesOf(gltf: GLTF, parser: Parser): [Mesh, ...Mesh[]][] {
  const faces: [Mesh, ...Mesh[]][] = []
  const seen = new Set<Object3D>()
  for (const scene of gltf.scenes) {
    scene.traverse((object) => {
      const mesh = object as Mesh
      if (!mesh.isMesh || seen.has(mesh)) return
      seen.add(mesh)
      const face = isPart(mesh, parser) && faces.find(([first]) => isSibling(first, mesh))
      if (face) face.push(mesh)
      else faces.push([mesh])
    })
  }
  return faces
}

function isSibling(first: Mesh, mesh: Mesh): boolean {
  return first.parent === mesh.parent && surfaceOf(first) === surfaceOf(mesh)
}

/** Whether a mesh is one of several primitives of a glTF mesh, which the loader turns into a group. */
function isPart(mesh: Mesh, parser: Parser): boolean {
  const index = parser.associations.get(mesh)?.meshes
  return index !== undefined && parser.json.meshes[index].primitives.length > 1
}
