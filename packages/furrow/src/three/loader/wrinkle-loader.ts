import type { Material, Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { WRINKLE_MAPS } from '../../core/wrinkle-maps.ts'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import { driversOf, type WrinkleDriver } from '../../drivers/registry.ts'
import { bindDrivers } from '../sources/bind-drivers.ts'
import type { InputBindings } from '../sources/binding.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { readWrinkleMaps } from './read-wrinkle-maps.ts'

/** The `Wrinkles` class of a renderer. */
type WrinklesClass = new (mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase) => WrinklesBase

/**
 * Adds the wrinkles of FURROW_wrinkle_maps to what `GLTFLoader` loads. A loaded face wrinkles by itself as its blendshapes move, without
 * calls in the render loop. So does each copy made by `clone()` or three.js's `SkeletonUtils.clone()`, with activations of its own and
 * the same textures. `gltf.userData.wrinkles` lists the wrinkles, one per face; `wrinklesOf` finds those of a mesh, copies included.
 * Drivers of a VRM may read its expressions if three-vrm's plugin is registered too.
 */
export class WrinkleLoader {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #Wrinkles: WrinklesClass
  readonly #bindings: InputBindings

  constructor(parser: GLTFParser, Wrinkles: WrinklesClass, bindings: InputBindings) {
    this.#parser = parser
    this.#Wrinkles = Wrinkles
    this.#bindings = bindings
  }

  /**
   * Called by the loader when everything else is loaded.
   *
   * @throws FurrowError when the extension is malformed or an image cannot be read; no wrinkles are then added.
   */
  async afterRoot(gltf: GLTF): Promise<void> {
    const wrinkles: WrinklesBase[] = []
    const bySet = new Map<WrinkleSet<ArraySlice>, WrinklesBase>()
    const faces = new Map<number, WrinklesBase[]>()
    const byMaterial = new Map<Material, WrinklesBase>()
    try {
      for (const { meshes, set, drivers } of await readWrinkleMaps(gltf, this.#parser)) {
        const material = meshes[0].material as Material
        const copy = byMaterial.get(material)?.cloneMaterial()
        // Another face with the same material has its own activations, and so needs its own material.
        if (copy) for (const mesh of meshes) mesh.material = copy
        await addMusclesOf(meshes[0], drivers)
        const own = this.#addWrinkles(
          meshes,
          bySet.get(set) ?? set,
          drivers,
          this.#isVrm() ? () => vrmOf(gltf) : undefined,
        )
        wrinkles.push(own)
        const index = this.#parser.associations.get(material)!.materials!
        faces.set(index, [...(faces.get(index) ?? []), own])
        if (!bySet.has(set)) bySet.set(set, own)
        if (!copy) byMaterial.set(material, own)
      }
      if (hasPointers(this.#parser)) {
        const { addActivationTracks } = await import('./key-frames.ts')
        await addActivationTracks(gltf, this.#parser, faces)
      }
    } catch (error) {
      for (const own of wrinkles) own.dispose()
      throw error
    }
    if (wrinkles.length > 0) gltf.userData.wrinkles = wrinkles
  }

  #isVrm(): boolean {
    const used: unknown[] = this.#parser.json.extensionsUsed ?? []
    return used.includes('VRMC_vrm') || used.includes('VRM')
  }

  /** Adds wrinkles to the meshes of one face, and to every copy of them. */
  #addWrinkles(
    [mesh, ...others]: readonly Mesh[],
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    drivers: readonly WrinkleDriver[],
    expressions?: () => VrmExpressions | undefined,
  ): WrinklesBase {
    const own = new this.#Wrinkles(mesh, source)
    for (const other of others) own.addMesh(other)
    const runtime = bindDrivers(own, drivers, () => ({ expressions: expressions?.() }), this.#bindings)
    // three-vrm may create a VRM's expressions after this: they are looked up when the face is first drawn.
    if (!expressions) runtime.bind()
    for (const part of [mesh, ...others]) this.#followClones(part, own, drivers)
    return own
  }

  #followClones(mesh: Mesh, own: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
    mesh.clone = (recursive) => {
      const copy: Mesh = Object.getPrototypeOf(mesh).clone.call(mesh, recursive)
      copy.material = own.cloneMaterial()
      this.#addWrinkles([copy], own, drivers)
      return copy as typeof mesh
    }
    own.onDispose(() => {
      delete (mesh as Partial<Mesh>).clone
    })
  }
}

/** Where three-vrm's plugins put the expressions. */
function vrmOf({ userData }: GLTF): VrmExpressions | undefined {
  return userData.vrmExpressionManager ?? userData.vrm?.expressionManager
}

/** Whether an animation moves what only a pointer reaches, such as an area. */
function hasPointers({ json }: GLTFParser): boolean {
  const animations: { channels: { target: { path: string } }[] }[] = json.animations ?? []
  return animations.some(({ channels }) => channels.some(({ target }) => target.path === 'pointer'))
}

/** Copies of the mesh share its geometry, and so its muscles. */
async function addMusclesOf(mesh: Mesh, drivers: readonly WrinkleDriver[]): Promise<void> {
  const muscles = driversOf('muscle', drivers)
  if (muscles.length > 0) (await import('../sources/muscles.ts')).addMuscles(mesh, muscles)
}
