import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { GLTFLoader } from '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import type { IGLTFLoaderExtension } from '@babylonjs/loaders/glTF/2.0/glTFLoaderExtension.js'
import type { INode, IScene } from '@babylonjs/loaders/glTF/2.0/glTFLoaderInterfaces.js'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { drivenFaces, type FaceMeasure } from '../../runtime/file/driven-faces.ts'
import type { GltfSource } from '../../runtime/file/gltf-source.ts'
import { notFetched } from '../../runtime/file/image-errors.ts'
import { extensionOf, type FileWrinkles, wrinkleReader } from '../../runtime/file/read-wrinkles.ts'
import { Warnings } from '../../runtime/file/warnings.ts'
import type { LoaderOptions, WrinklesOptions } from '../options.ts'
import { targetNames } from '../sources/morph.ts'
import { WrinkledMesh } from '../wrinkled-mesh.ts'

/** A face in a file: all meshes of one node that share a wrinkled material. */
interface FileFace {
  /** Meshes of the face. Drivers read inputs from the first mesh. */
  meshes: AbstractMesh[]
  /** Index of the material in the file. */
  material: number
}

/**
 * Extension of Babylon.js's glTF loader that reads FURROW_wrinkle_maps and adds wrinkles to the loaded meshes. If the wrinkles of a file
 * are invalid or unsupported, the file is loaded without wrinkles, and a warning is logged.
 */
export class WrinkleMapsExtension implements IGLTFLoaderExtension {
  readonly name = WRINKLE_MAPS
  enabled = true
  readonly #loader: GLTFLoader
  readonly #options: WrinklesOptions
  readonly #transcoderPath: string | undefined
  readonly #warnings = new Warnings('registerWrinkleMaps')

  constructor(loader: GLTFLoader, { transcoderPath, ...options }: LoaderOptions) {
    this.#loader = loader
    this.#options = options
    this.#transcoderPath = transcoderPath
  }

  /**
   * Loads the scene, and then adds the wrinkles. The loader's callback `onReady` is not used to add them, because Babylon.js 8 would not wait
   * for its promise.
   */
  async loadSceneAsync(context: string, scene: IScene): Promise<void> {
    await this.#loader.loadSceneAsync(context, scene)
    await this.#addAll()
  }

  dispose(): void {}

  async #addAll(): Promise<void> {
    const faces = facesOf(this.#loader)
    if (faces.length === 0) return
    const read = wrinkleReader(fileOf(this.#loader, this.#transcoderPath), (errors) =>
      this.#warnings.addDrivers(errors),
    )
    const first = new Map<FileWrinkles['set'], WrinkledMesh>()
    for (const material of new Set(faces.map(({ material }) => material))) {
      const candidates = faces.filter((face) => face.material === material)
      const stayPlain = (error: unknown) => {
        const name = this.#loader.gltf.materials?.[material].name ?? material
        this.#warnings.add(error, `material ${JSON.stringify(name)} is shown without wrinkles`)
      }
      try {
        const wrinkles = await read(material)
        for (const { meshes } of drivenFaces(candidates, measureOf, wrinkles.drivers)) {
          try {
            this.#add(meshes, wrinkles, first)
          } catch (error) {
            stayPlain(error)
          }
        }
      } catch (error) {
        stayPlain(error)
      }
    }
  }

  #add(
    [mesh, ...others]: AbstractMesh[],
    { set, drivers }: FileWrinkles,
    first: Map<FileWrinkles['set'], WrinkledMesh>,
  ): void {
    const face = new WrinkledMesh(mesh, first.get(set) ?? set, this.#options)
    try {
      for (const other of others) face.addMesh(other)
      face.drive(drivers)
    } catch (error) {
      face.dispose()
      throw error
    }
    if (!first.has(set)) first.set(set, face)
  }
}

function measureOf({ meshes }: FileFace): FaceMeasure {
  return {
    targets: targetNames(meshes[0].morphTargetManager),
    vertices: meshes.reduce((sum, mesh) => sum + mesh.getTotalVertices(), 0),
  }
}

/** Finds all faces whose material has the extension, even if the extension is malformed. */
function facesOf({ gltf }: GLTFLoader): FileFace[] {
  const wrinkled = (gltf.materials ?? []).filter(
    ({ index }) => extensionOf(index, { json: gltf }) !== undefined,
  )
  return (gltf.nodes ?? []).flatMap((node) =>
    wrinkled.flatMap(({ index, _data }) => {
      const materials = Object.values(_data ?? {}).map(({ babylonMaterial }) => babylonMaterial)
      const meshes = meshesOf(node).filter(({ material }) => material && materials.includes(material))
      return meshes.length > 0 ? [{ meshes, material: index }] : []
    }),
  )
}

function meshesOf({ _primitiveBabylonMeshes: meshes }: INode): readonly AbstractMesh[] {
  return meshes ?? []
}

/** Adapts the file of a loader to `GltfSource`. The KTX 2 decoder (`ktx2.ts`) is imported when a file needs it. */
function fileOf(loader: GLTFLoader, transcoderPath: string | undefined): GltfSource {
  const { gltf } = loader
  const readBytes: GltfSource['readBytes'] = async (index, who) => {
    const image = gltf.images?.[index as number]
    if (!image) return undefined
    try {
      const bytes = await loader.loadImageAsync(`/images/${index}`, image)
      return new Uint8Array(bytes.buffer as ArrayBuffer, bytes.byteOffset, bytes.byteLength)
    } catch {
      throw notFetched(image.uri ?? `image ${index}`, who)
    }
  }
  return {
    json: {
      ...gltf,
      materials: withoutPrivateFields(gltf.materials),
      extensions: withoutPrivateFields(gltf.extensions),
    },
    readBytes,
    prefersArrays: false,
    fetchArrays: async () => {
      const { loadKtx2, withImages } = await import('./ktx2.ts')
      return {
        async load(index, _use, check) {
          const who = `${WRINKLE_MAPS} texture ${index}`
          const source = gltf.textures?.[index].extensions?.KHR_texture_basisu?.source
          return loadKtx2(await readBytes(source, who), who, check, transcoderPath)
        },
        join: withImages,
      }
    },
  }
}

/** Copies JSON without the properties that Babylon.js adds to it. Their names begin with an underscore, and their values contain cycles. */
function withoutPrivateFields(json: unknown): unknown {
  const text = JSON.stringify(json, (name, value) => (name.startsWith('_') ? undefined : value))
  return text && JSON.parse(text)
}
