import type { Material, Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { AutoCharacterOptions } from '../../auto/run-options.ts'
import { isObject } from '../../core/argument.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { vrmExpressions } from '../../drivers/morph/vrm-binds.ts'
import type { FileWrinkles } from '../../runtime/file/read-wrinkles.ts'
import { Warnings } from '../../runtime/file/warnings.ts'
import { nextTask } from '../../runtime/next-task.ts'
import { ReadSet } from '../check-source.ts'
import { surfaceOf } from '../material/surface.ts'
import {
  checkLoaderOptions,
  WRINKLES_DEFAULTS,
  type WrinkleLoaderOptions,
  type WrinklesOptions,
} from '../options.ts'
import { combinableTargets } from '../sources/combined-targets.ts'
import type { InputOptions } from '../sources/target.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { Adoption, type WatchDraws } from './adoption.ts'
import type { AddFace } from './auto-wrinkles.ts'
import { DeclaredWrinkles } from './declared-wrinkles.ts'
import { addActivationTracks, dropInvalidChannels, type LoadedFace } from './key-frames.ts'
import {
  chooseFaces,
  facesOf,
  materialReader,
  separateOthers,
  type WrinkledMaterial,
  wrinkledMaterials,
} from './read-wrinkle-maps.ts'

type WrinklesClass = new (
  mesh: Mesh,
  source: WrinkleSet<ArraySlice> | WrinklesBase,
  options: WrinklesOptions,
) => WrinklesBase

/** Renderer-specific parts of the loader. */
export interface LoaderParts {
  Wrinkles: WrinklesClass
  watchDraws: WatchDraws
}

/**
 * Plugin of `GLTFLoader` that adds the wrinkles in the glTF extension FURROW_wrinkle_maps to loaded faces. Wrinkles follow blendshapes
 * automatically, without calls in the render loop.
 *
 * `wrinklesOf(gltf)` returns the wrinkles of a file, one per face. `wrinklesOf(mesh)` returns the wrinkles of a mesh. Copies made with
 * `clone()` or `SkeletonUtils.clone()`, and meshes that the page creates with the material of a face (as in JSX), also get wrinkles. They have
 * separate activations and share textures. Drivers can read VRM expressions if three-vrm's plugin is registered too.
 *
 * With the option `auto`, wrinkles are generated after loading for files without wrinkles, one mesh after another. Await
 * `wrinklesReady(gltf)` to use them.
 *
 * A file never fails to load because of its wrinkles. If the wrinkles are invalid or unsupported, the face has none, and one warning is logged.
 */
export class WrinkleLoader {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #parts: LoaderParts
  readonly #options: Required<WrinklesOptions>
  readonly #auto: AutoCharacterOptions | undefined
  readonly #warnings = new Warnings('WrinkleLoaderPlugin')
  readonly #declared: DeclaredWrinkles
  /** First face with each wrinkle set. Later faces with the same set share the textures of the first face. */
  readonly #bySet = new Map<FileWrinkles['set'], WrinklesBase>()
  /** First face with each material. */
  readonly #byMaterial = new Map<Material, WrinklesBase>()
  /** Reads the wrinkles of a material; cached. */
  readonly #read: ReturnType<typeof materialReader>

  constructor(parser: GLTFParser, parts: LoaderParts, options: WrinkleLoaderOptions) {
    if (!isObject(parser?.json)) throw invalidParser(parser)
    checkLoaderOptions(options, 'WrinkleLoaderPlugin')
    const { auto, ...others } = options
    const { areaSize } = others
    this.#auto = auto && { ...(areaSize !== undefined && { areaSize }), ...auto }
    this.#options = { ...WRINKLES_DEFAULTS, ...others }
    this.#parser = parser
    this.#parts = parts
    this.#declared = new DeclaredWrinkles(parser)
    this.#read = materialReader(parser, (errors) => this.#warnings.addDrivers(errors))
  }

  /** Starts reading wrinkles while `GLTFLoader` loads the file. `GLTFLoader` calls this method before it loads anything. */
  async beforeRoot(): Promise<void> {
    this.#declared.restore()
    // `afterRoot` awaits the same promises and reports errors.
    for (const material of this.#declared.materials) this.#read(material).catch(() => {})
    // Downloads the code while the file loads.
    if (this.#auto) import('./auto-wrinkles.ts').catch(() => {})
    if (hasPointers(this.#parser)) dropInvalidChannels(this.#parser, this.#warnings)
  }

  /** Adds wrinkles to the faces of the file. `GLTFLoader` calls this method after it has loaded everything else. */
  async afterRoot(gltf: GLTF): Promise<void> {
    const wrinkles: WrinklesBase[] = []
    gltf.userData.wrinkles = wrinkles
    this.#declared.restore()
    const faces: LoadedFace[] = []
    const addFace: AddFace = (meshes, read) => this.#addFace(meshes, read, gltf)
    const wrinkled = wrinkledMaterials(gltf, this.#parser)
    if (this.#auto && wrinkled.length === 0) {
      try {
        const { beginAuto } = await import('./auto-wrinkles.ts')
        beginAuto(gltf, facesOf(gltf, this.#parser), this.#auto, addFace, this.#warnings)
      } catch (error) {
        this.#warnings.add(error, 'the file is shown without wrinkles')
      }
    }
    for (const wrinkledMaterial of wrinkled) {
      const { material } = wrinkledMaterial
      const stayPlain = (error: unknown) => {
        const { name } = this.#parser.json.materials[material]
        this.#warnings.add(error, `material ${JSON.stringify(name ?? material)} is shown without wrinkles`)
      }
      try {
        const read = await this.#read(material)
        for (const meshes of separatedFaces(wrinkledMaterial, read)) {
          try {
            const added = await addFace(meshes, read)
            wrinkles.push(added)
            faces.push({ material, wrinkles: added })
          } catch (error) {
            stayPlain(error)
          }
        }
      } catch (error) {
        stayPlain(error)
      }
    }
    if (faces.length === 0 || !hasPointers(this.#parser)) return
    await addActivationTracks(gltf, this.#parser, faces, this.#warnings)
  }

  get #isVrm(): boolean {
    const used: unknown[] = this.#parser.json.extensionsUsed ?? []
    return used.includes('VRMC_vrm') || used.includes('VRM')
  }

  async #addFace(
    meshes: [Mesh, ...Mesh[]],
    { set, drivers }: FileWrinkles,
    file: GLTF,
  ): Promise<WrinklesBase> {
    const material = surfaceOf(meshes[0])
    const copy = this.#byMaterial.get(material)?.cloneMaterial()
    // Each face needs a separate material, because the uniforms of a material belong to one face.
    if (copy) for (const mesh of meshes) mesh.material = copy
    // Packing all maps takes long. It runs in a separate task, so that the page stays responsive after the last image is decoded.
    await nextTask()
    const wrinkles = this.#addWrinkles(meshes, this.#bySet.get(set) ?? new ReadSet(set))
    try {
      // Inputs of a VRM are looked up in the first frame, because three-vrm may create the expressions after this plugin runs.
      meshOf(wrinkles).drive(drivers, this.#inputsOf(meshes[0], file), this.#isVrm)
    } catch (error) {
      wrinkles.dispose()
      throw error
    }
    if (!this.#bySet.has(set)) this.#bySet.set(set, wrinkles)
    if (!copy) this.#byMaterial.set(material, wrinkles)
    return wrinkles
  }

  /** Returns the sources of driver inputs other than the mesh itself. For a VRM these are its expressions, and its blendshapes as stored in the file. */
  #inputsOf(mesh: Mesh, { userData }: GLTF): InputOptions {
    if (!this.#isVrm) return {}
    const { json, associations } = this.#parser
    const index = associations.get(mesh)?.meshes
    return {
      vrmExpressions: vrmExpressions(json),
      // The plugins of three-vrm set these properties.
      expressions: () => userData.vrmExpressionManager ?? userData.vrm?.expressionManager,
      ...(index !== undefined && { targetsOf: combinableTargets(json, index) }),
    }
  }

  /** Adds wrinkles to the meshes of one face, to their clones, and to other meshes that are drawn with their material. */
  #addWrinkles(
    meshes: readonly Mesh[],
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    copyOf?: WrinklesBase,
  ): WrinklesBase {
    const { Wrinkles, watchDraws: watch } = this.#parts
    const [mesh, ...others] = meshes
    const parts = { watch, add: (adopted: Mesh, from: WrinklesBase) => this.#tryAdd(adopted, from) }
    const adoption = new Adoption(surfaceOf(mesh), meshes, parts, copyOf)
    let wrinkles: WrinklesBase | undefined
    try {
      wrinkles = new Wrinkles(mesh, source, this.#options)
      adoption.begin(wrinkles)
      for (const other of others) wrinkles.addMesh(other)
    } catch (error) {
      adoption.end()
      wrinkles?.dispose()
      throw error
    }
    for (const part of meshes) this.#followClones(part, wrinkles)
    return wrinkles
  }

  #tryAdd(mesh: Mesh, source: WrinklesBase): WrinklesBase | undefined {
    try {
      return this.#addWrinkles([mesh], source)
    } catch (error) {
      this.#warnings.add(error, `mesh ${JSON.stringify(mesh.name)} is shown without wrinkles`)
      return undefined
    }
  }

  #followClones(mesh: Mesh, face: WrinklesBase): void {
    mesh.clone = (recursive) => {
      const copy: Mesh = Object.getPrototypeOf(mesh).clone.call(mesh, recursive)
      copy.material = face.cloneMaterial()
      this.#addWrinkles([copy], face, face)
      return copy as typeof mesh
    }
    face.onDispose(() => {
      delete (mesh as Partial<Mesh>).clone
    })
  }
}

/** Returns the faces that show the wrinkles of a material. All other meshes with the material get a copy of it without wrinkles. */
function separatedFaces({ faces }: WrinkledMaterial, read: FileWrinkles): [Mesh, ...Mesh[]][] {
  const chosen = chooseFaces(faces, read)
  const others = faces.filter((meshes) => !chosen.includes(meshes)).flat()
  separateOthers(others, surfaceOf(faces[0][0]))
  return chosen
}

function invalidParser(given: unknown): FurrowError {
  return new FurrowError({
    who: 'WrinkleLoaderPlugin',
    problem: 'invalid parser',
    value: given === null || given === undefined ? String(given) : (given as object).constructor?.name,
    limit: 'the GLTFParser that GLTFLoader passes to registered callbacks',
    remedy: 'call extendLoader(loader), or loader.register((parser) => new WrinkleLoaderPlugin(parser))',
  })
}

/** Whether an animation uses KHR_animation_pointer. */
function hasPointers({ json: { animations } }: GLTFParser): boolean {
  const isPointer = (channel?: { target?: { path?: unknown } } | null) => channel?.target?.path === 'pointer'
  return (
    Array.isArray(animations) &&
    animations.some((animation) => Array.isArray(animation?.channels) && animation.channels.some(isPointer))
  )
}
