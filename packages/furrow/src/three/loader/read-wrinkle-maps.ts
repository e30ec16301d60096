import type { Material, Mesh, Object3D } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { drivenFaces } from '../../runtime/file/driven-faces.ts'
import type { GltfSource } from '../../runtime/file/gltf-source.ts'
import {
  extensionOf,
  type FileWrinkles,
  type OnDriverErrors,
  wrinkleReader,
} from '../../runtime/file/read-wrinkles.ts'
import { surfaceOf, withSurface } from '../material/surface.ts'
import type { RaisedLayer } from '../relief/raised-layer.ts'
import { targetNames } from '../sources/morph.ts'
import { readImageBytes } from './image-bytes.ts'

/** The wrinkle set, drivers and meshes of one face in a file. */
export interface LoadedWrinkles extends FileWrinkles {
  /** Meshes of the face: all primitives of a glTF mesh that share the material. Drivers read the first one. */
  meshes: [Mesh, ...Mesh[]]
}

type Parser = GLTF['parser']

/**
 * Reads the glTF extension FURROW_wrinkle_maps from a file that `GLTFLoader` has loaded. Creates no `Wrinkles`; `WrinkleLoaderPlugin` reads
 * the extension and creates them. For VRM 0 files, register `WrinkleLoaderPlugin` even if you only call this function: three-vrm removes the
 * extension, and the plugin restores it.
 *
 * @param gltf result of the loader.
 * @param parser parser of the loader, default `gltf.parser`.
 * @returns one entry per face. Meshes without the blendshapes that drivers read, such as eyes with the same material, are left out (see
 *   `drivenFaces`).
 * @throws FurrowError if the extension is malformed, or an image cannot be read.
 */
export async function readWrinkleMaps(gltf: GLTF, parser: Parser = gltf.parser): Promise<LoadedWrinkles[]> {
  const read = materialReader(parser)
  const found: LoadedWrinkles[] = []
  for (const { material, faces } of wrinkledMaterials(gltf, parser)) {
    const wrinkles = await read(material)
    await Promise.all(wrinkles.set.layers.map(decodeHeight))
    for (const meshes of chooseFaces(faces, wrinkles)) found.push({ meshes, ...wrinkles })
  }
  return found
}

async function decodeHeight(layer: RaisedLayer): Promise<void> {
  if (!layer.readHeight) return
  layer.height = await layer.readHeight()
  delete layer.readHeight
}

export interface WrinkledMaterial {
  /** Material index in the file. */
  material: number
  /** Meshes grouped by face, see `facesOf`. */
  faces: [Mesh, ...Mesh[]][]
}

/** Returns the materials with the extension, even if the extension is malformed. */
export function wrinkledMaterials(gltf: GLTF, parser: Parser): WrinkledMaterial[] {
  const found = new Map<number, WrinkledMaterial>()
  for (const meshes of facesOf(gltf, parser)) {
    // `GLTFLoader` may clone a material. `associations` has the index in the file for each clone.
    const material = parser.associations.get(surfaceOf(meshes[0]))?.materials
    if (material === undefined || extensionOf(material, parser) === undefined) continue
    const known = found.get(material) ?? { material, faces: [] }
    known.faces.push(meshes)
    found.set(material, known)
  }
  return [...found.values()]
}

/** Selects the faces among the meshes that share a material, see `drivenFaces`. */
export function chooseFaces(
  faces: readonly [Mesh, ...Mesh[]][],
  { drivers }: Pick<FileWrinkles, 'drivers'>,
): [Mesh, ...Mesh[]][] {
  const measure = (meshes: readonly Mesh[]) => ({
    targets: targetNames(meshes[0]),
    vertices: meshes.reduce((sum, { geometry }) => sum + (geometry.attributes.position?.count ?? 0), 0),
  })
  return drivenFaces(faces, measure, drivers)
}

/** Replaces the material of meshes that must not show wrinkles by a copy without wrinkles. */
export function separateOthers(others: readonly Mesh[], surface: Material): void {
  if (others.length === 0) return
  const plain = surface.clone()
  for (const mesh of others) mesh.material = withSurface(mesh, surface, plain)
}

/** Returns a function that reads the wrinkles of a material from a file that `GLTFLoader` loads, see `wrinkleReader`. */
export function materialReader(
  parser: Parser,
  onDriverErrors?: OnDriverErrors,
): (material: number) => Promise<FileWrinkles> {
  return wrinkleReader(fileOf(parser), onDriverErrors)
}

/** Adapts a parser to the interface of `wrinkleReader`. Imports the code for KTX 2 only when a file needs it. */
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

/** Groups the meshes of a file by face. Primitives of one glTF mesh with the same material are one face. */
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

/** Whether a mesh is one of several primitives of a glTF mesh. `GLTFLoader` puts these primitives into one group. */
function isPart(mesh: Mesh, parser: Parser): boolean {
  const index = parser.associations.get(mesh)?.meshes
  return index !== undefined && parser.json.meshes[index].primitives.length > 1
}
