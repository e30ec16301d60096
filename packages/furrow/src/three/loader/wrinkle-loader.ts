import type { Material, Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { WRINKLE_MAPS } from '../../core/wrinkle-maps.ts'
import { expressionsOf } from '../../drivers/expression.ts'
import type { WrinkleDriver } from '../../drivers/types.ts'
import type { VrmExpressions } from '../../drivers/vrm.ts'
import type { AddDrivers } from '../drivers.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { addActivationTracks } from './key-frames.ts'
import { readWrinkleMaps } from './read-wrinkle-maps.ts'

/** A renderer's class of wrinkles. */
type WrinklesClass = new (mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase) => WrinklesBase

/**
 * Puts the wrinkles of FURROW_wrinkle_maps on what `GLTFLoader` loads. A loaded face wrinkles by itself as its
 * blendshapes move: nothing is to be called in the render loop. So does each copy that `clone()` or
 * three.js's `SkeletonUtils.clone()` makes of it, with activations of its own and the same textures. The wrinkles
 * stand in `gltf.userData.wrinkles`, one for each face that has them, to be switched, looked at or disposed of;
 * `wrinklesOf` tells those of a mesh, copies included. Links of a VRM's drivers may name its expressions, where three-vrm's plugin is
 * registered as well.
 */
export class WrinkleLoader {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #Wrinkles: WrinklesClass
  readonly #addDrivers: AddDrivers

  constructor(parser: GLTFParser, Wrinkles: WrinklesClass, addDrivers: AddDrivers) {
    this.#parser = parser
    this.#Wrinkles = Wrinkles
    this.#addDrivers = addDrivers
  }

  /** Called by the loader when all else is there. Rejects with a FurrowError where the extension is malformed. */
  async afterRoot(gltf: GLTF): Promise<void> {
    const wrinkles: WrinklesBase[] = []
    const bySet = new Map<WrinkleSet<ArraySlice>, WrinklesBase>()
    const faces = new Map<number, WrinklesBase[]>()
    const byMaterial = new Map<Material, WrinklesBase>()
    try {
      for (const { meshes, set, drivers } of await readWrinkleMaps(gltf, this.#parser)) {
        const material = meshes[0].material as Material
        const taken = byMaterial.get(material)?.cloneMaterial()
        // Another face with the same material wrinkles by itself, and needs one of its own for that.
        if (taken) for (const mesh of meshes) mesh.material = taken
        const own = this.#wear(
          meshes,
          bySet.get(set) ?? set,
          drivers,
          this.#isVrm() ? () => vrmOf(gltf) : undefined,
        )
        wrinkles.push(own)
        const index = this.#parser.associations.get(material)!.materials!
        faces.set(index, [...(faces.get(index) ?? []), own])
        if (!bySet.has(set)) bySet.set(set, own)
        if (!taken) byMaterial.set(material, own)
      }
      await addActivationTracks(gltf, this.#parser, faces)
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

  /** Puts wrinkles on the meshes of one face, and has every copy of them wrinkle likewise. */
  #wear(
    [mesh, ...others]: readonly Mesh[],
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    drivers: readonly WrinkleDriver[],
    expressions?: () => VrmExpressions | undefined,
  ): WrinklesBase {
    const own = new this.#Wrinkles(mesh, source)
    for (const other of others) own.addMesh(other)
    if (expressions) this.#addWhenDrawn(own, drivers, expressions)
    else this.#addDrivers(own, drivers)
    for (const part of [mesh, ...others]) this.#followClones(part, own, drivers)
    return own
  }

  /** three-vrm makes a VRM's expressions while this plugin is at work, so drivers look for them when the face is first drawn. */
  #addWhenDrawn(
    own: WrinklesBase,
    drivers: readonly WrinkleDriver[],
    expressions: () => VrmExpressions | undefined,
  ): void {
    own.expressions = expressionsOf(drivers)
    let isAdded = false
    const areas = drivers.flatMap((driver) => ('area' in driver ? [String(driver.area)] : []))
    own.onDrive(() => {
      if (isAdded) return
      isAdded = true
      this.#addDrivers(own, drivers, { expressions: expressions() })
    }, areas)
  }

  #followClones(mesh: Mesh, own: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
    mesh.clone = (recursive) => {
      const copy: Mesh = Object.getPrototypeOf(mesh).clone.call(mesh, recursive)
      copy.material = own.cloneMaterial()
      this.#wear([copy], own, drivers)
      return copy as typeof mesh
    }
    own.onDispose(() => {
      delete (mesh as Partial<Mesh>).clone
    })
  }
}

/** What three-vrm's plugins leave there. */
function vrmOf({ userData }: GLTF): VrmExpressions | undefined {
  return userData.vrmExpressionManager ?? userData.vrm?.expressionManager
}
