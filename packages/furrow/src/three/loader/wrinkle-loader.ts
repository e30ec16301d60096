import type { Material, Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { AutoRunOptions } from '../../auto/run-options.ts'
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
import { addActivationTracks, dropBrokenChannels, type LoadedFace } from './key-frames.ts'
import {
  chooseFaces,
  facesOf,
  materialReader,
  separateOthers,
  type WrinkledMaterial,
  wrinkledMaterials,
} from './read-wrinkle-maps.ts'

/** The `Wrinkles` class of a renderer. */
type WrinklesClass = new (
  mesh: Mesh,
  source: WrinkleSet<ArraySlice> | WrinklesBase,
  options: WrinklesOptions,
) => WrinklesBase

/** What depends on the renderer. */
export interface LoaderParts {
  Wrinkles: WrinklesClass
  watchDraws: WatchDraws
}

/**
 * Adds the wrinkles of FURROW_wrinkle_maps to what `GLTFLoader` loads. A loaded face wrinkles by itself as its blendshapes move, without
 * calls in the render loop. So does each copy made by `clone()` or three.js's `SkeletonUtils.clone()`, with activations of its own and
 * the same textures, and each mesh that a page makes with the material of a face, as JSX does. `wrinklesOf(gltf)` lists the wrinkles,
 * one per face, as `gltf.userData.wrinkles` does; `wrinklesOf(mesh)` finds those of a mesh. Drivers of a VRM may read its expressions if
 * three-vrm's plugin is registered too.
 *
 * With the option `auto`, a file without wrinkles gets them some time after it was loaded: `wrinklesReady(gltf)` waits for them.
 *
 * A file never fails to load because of its wrinkles: a face whose wrinkles are damaged or not possible stays plain, with one warning.
 */
export class WrinkleLoader {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #parts: LoaderParts
  readonly #options: Required<WrinklesOptions>
  readonly #auto: AutoRunOptions | undefined
  readonly #warnings = new Warnings('WrinkleLoaderPlugin')
  readonly #declared: DeclaredWrinkles
  /** The first of each set, whose textures all others use. */
  readonly #bySet = new Map<FileWrinkles['set'], WrinklesBase>()
  /** The first of each material. */
  readonly #byMaterial = new Map<Material, WrinklesBase>()
  /** Reads the wrinkles of a material, once. */
  readonly #read: ReturnType<typeof materialReader>

  constructor(parser: GLTFParser, parts: LoaderParts, options: WrinkleLoaderOptions) {
    if (!isObject(parser?.json)) throw withoutParser(parser)
    checkLoaderOptions(options, 'WrinkleLoaderPlugin')
    const { auto, ...others } = options
    this.#auto = auto
    this.#options = { ...WRINKLES_DEFAULTS, ...others }
    this.#parser = parser
    this.#parts = parts
    this.#declared = new DeclaredWrinkles(parser)
    this.#read = materialReader(parser, (faults) => this.#warnings.addDrivers(faults))
  }

  /** Begins to read the wrinkles while the rest is loaded. Called by the loader before it loads anything. */
  async beforeRoot(): Promise<void> {
    this.#declared.restore()
    // Faults are reported when the wrinkles are added.
    for (const material of this.#declared.materials) this.#read(material).catch(() => {})
    // Arrives while the rest is loaded.
    if (this.#auto) import('./auto-wrinkles.ts').catch(() => {})
    if (hasPointers(this.#parser)) dropBrokenChannels(this.#parser, this.#warnings)
  }

  /** Called by the loader when everything else is loaded. */
  async afterRoot(gltf: GLTF): Promise<void> {
    const wrinkles: WrinklesBase[] = []
    gltf.userData.wrinkles = wrinkles
    this.#declared.restore()
    const faces: LoadedFace[] = []
    const addFace: AddFace = (meshes, read) => this.#addFace(meshes, read, gltf)
    const wrinkled = wrinkledMaterials(gltf, this.#parser)
    if (this.#auto && wrinkled.length === 0) {
      const options = { areaSize: this.#options.areaSize, ...this.#auto }
      try {
        const { beginAuto } = await import('./auto-wrinkles.ts')
        beginAuto(gltf, facesOf(gltf, this.#parser), options, addFace, this.#warnings)
      } catch (error) {
        this.#warnings.add(error, 'the file stays plain')
      }
    }
    for (const own of wrinkled) {
      const { material } = own
      const stayPlain = (error: unknown) => {
        const { name } = this.#parser.json.materials[material]
        this.#warnings.add(error, `material ${JSON.stringify(name ?? material)} stays plain`)
      }
      try {
        const read = await this.#read(material)
        for (const meshes of separatedFaces(own, read)) {
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
    // Another face with the same material has its own activations, and so needs its own material.
    if (copy) for (const mesh of meshes) mesh.material = copy
    // What comes after it packs all maps: a task of its own, after that of the last image.
    await nextTask()
    const own = this.#addWrinkles(meshes, this.#bySet.get(set) ?? new ReadSet(set))
    try {
      // three-vrm may create a VRM's expressions after this.
      meshOf(own).drive(drivers, this.#inputsOf(meshes[0], file), this.#isVrm)
    } catch (error) {
      own.dispose()
      throw error
    }
    if (!this.#bySet.has(set)) this.#bySet.set(set, own)
    if (!copy) this.#byMaterial.set(material, own)
    return own
  }

  /** Where the drivers of a face find its inputs. A VRM has them elsewhere than in its meshes. */
  #inputsOf(mesh: Mesh, { userData }: GLTF): InputOptions {
    if (!this.#isVrm) return {}
    const { json, associations } = this.#parser
    const index = associations.get(mesh)?.meshes
    return {
      vrmExpressions: vrmExpressions(json),
      // Set by the plugins of three-vrm.
      expressions: () => userData.vrmExpressionManager ?? userData.vrm?.expressionManager,
      ...(index !== undefined && { targetsOf: combinableTargets(json, index) }),
    }
  }

  /** Adds wrinkles to the meshes of one face, to every copy of them, and to what is drawn with their material. */
  #addWrinkles(
    meshes: readonly Mesh[],
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    copyOf?: WrinklesBase,
  ): WrinklesBase {
    const { Wrinkles, watchDraws: watch } = this.#parts
    const [mesh, ...others] = meshes
    const parts = { watch, add: (adopted: Mesh, from: WrinklesBase) => this.#tryAdd(adopted, from) }
    const adoption = new Adoption(surfaceOf(mesh), meshes, parts, copyOf)
    let own: WrinklesBase | undefined
    try {
      own = new Wrinkles(mesh, source, this.#options)
      adoption.begin(own)
      for (const other of others) own.addMesh(other)
    } catch (error) {
      adoption.end()
      own?.dispose()
      throw error
    }
    for (const part of meshes) this.#followClones(part, own)
    return own
  }

  /** For a mesh that the page made. */
  #tryAdd(mesh: Mesh, source: WrinklesBase): WrinklesBase | undefined {
    try {
      return this.#addWrinkles([mesh], source)
    } catch (error) {
      this.#warnings.add(error, `mesh ${JSON.stringify(mesh.name)} stays plain`)
      return undefined
    }
  }

  #followClones(mesh: Mesh, own: WrinklesBase): void {
    mesh.clone = (recursive) => {
      const copy: Mesh = Object.getPrototypeOf(mesh).clone.call(mesh, recursive)
      copy.material = own.cloneMaterial()
      this.#addWrinkles([copy], own, own)
      return copy as typeof mesh
    }
    own.onDispose(() => {
      delete (mesh as Partial<Mesh>).clone
    })
  }
}

/** The faces of a material; other meshes that have it stay plain. */
function separatedFaces({ faces }: WrinkledMaterial, read: FileWrinkles): [Mesh, ...Mesh[]][] {
  const chosen = chooseFaces(faces, read)
  const others = faces.filter((meshes) => !chosen.includes(meshes)).flat()
  separateOthers(others, surfaceOf(faces[0][0]))
  return chosen
}

function withoutParser(given: unknown): FurrowError {
  return new FurrowError({
    who: 'WrinkleLoaderPlugin',
    problem: 'a parser',
    value: given === null || given === undefined ? String(given) : (given as object).constructor?.name,
    limit: 'the GLTFParser that GLTFLoader passes to what is registered',
    remedy: 'call extendLoader(loader), or loader.register((parser) => new WrinkleLoaderPlugin(parser))',
  })
}

/** Whether an animation moves what only a pointer reaches, such as an area. */
function hasPointers({ json: { animations } }: GLTFParser): boolean {
  const isPointer = (channel?: { target?: { path?: unknown } } | null) => channel?.target?.path === 'pointer'
  return (
    Array.isArray(animations) &&
    animations.some((animation) => Array.isArray(animation?.channels) && animation.channels.some(isPointer))
  )
}
