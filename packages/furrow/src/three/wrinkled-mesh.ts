import { type Material, type Mesh, REVISION } from 'three'
import { checkAreas } from '../core/check-areas.ts'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { driversOf } from '../drivers/of-type.ts'
import { type DriverPlan, planDrivers } from '../drivers/plan.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { applyDrivers } from '../runtime/apply-drivers.ts'
import { exposeAreas } from './animated-areas.ts'
import { createAreaArray } from './atlas/area-array.ts'
import { FramedMesh } from './framed-mesh.ts'
import { checkMaterial } from './material/check-material.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import { exchangeAreas } from './material/shader-inputs.ts'
import { watchReplacement } from './material/watch-replacement.ts'
import { createTextures } from './material/wrinkle-textures.ts'
import { callBeforeRender } from './mesh/before-render.ts'
import { checkIsMesh, checkMesh } from './mesh/check-mesh.ts'
import { addMissingWeights } from './mesh/missing-weights.ts'
import { checkOptions, WRINKLES_DEFAULTS, type WrinklesOptions } from './options.ts'
import { bindInputs } from './sources/bind-inputs.ts'
import { addMuscles } from './sources/muscles.ts'
import type { InputOptions } from './sources/target.ts'
import { checkThree } from './three-version.ts'

/**
 * Shows a wrinkle set on the meshes of a face: creates textures, patches the material, and connects drivers. `Wrinkles` is the public class
 * around it.
 */
export class WrinkledMesh extends FramedMesh {
  #inputOptions: InputOptions = {}

  /**
   * @param source a checked set, or another wrinkled mesh, whose areas, textures and drivers are then shared. Activations are not copied.
   * @throws FurrowError if the mesh, its material or the set is invalid; the mesh is then unchanged.
   */
  constructor(
    renderer: RendererParts,
    mesh: Mesh,
    source: WrinkleSet<ArraySlice> | WrinkledMesh,
    options?: WrinklesOptions,
  ) {
    checkThree(renderer.entry, REVISION)
    const shared = source instanceof WrinkledMesh ? source : null
    shared?.checkInUse('set')
    const all = { ...WRINKLES_DEFAULTS, ...shared?.options, ...options }
    checkOptions(all, 'Wrinkles')
    checkMesh(mesh)
    const material = checkMaterial(mesh)
    const { areas: given } = source
    const { layers } = shared?.shaderInputs.textures ?? (source as WrinkleSet<ArraySlice>)
    const areas = shared?.shaderInputs.areas ?? createAreaArray(given, layers, all.areaSize, 'Wrinkles')
    const textures =
      shared?.shaderInputs.textures ?? createTextures(layers, material.normalMap?.anisotropy ?? 1)
    const ownAreas = shared ? given : copyAreas(given)
    super({ renderer, mesh, material, options: all, areas: ownAreas, array: areas, textures })
    this.addMesh(mesh)
    this.relief.mode = all.relief
    try {
      this.mode = all.mode
      this.#driveAs(source)
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  /** @throws FurrowError if an area is unknown. */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    this.checkInUse('createInfluenceMaterial')
    this.resume()
    if (area === undefined) return this.material.influenceMaterial()
    const names = [area].flat()
    for (const name of names) this.getActivation(name)
    return this.material.influenceMaterial({ areas: this.areas, names })
  }

  addMesh(mesh: Mesh): void {
    this.checkInUse('addMesh')
    checkIsMesh(mesh, 'Wrinkles.addMesh')
    addMuscles(mesh, driversOf('muscle', this.drivers))
    this.meshes.push(mesh)
    this.material.follow(mesh)
    if (mesh === this.mesh) exposeAreas(mesh, this)
    const checkReplacement = watchReplacement(mesh, this.material)
    this.onDispose(
      callBeforeRender(mesh, (renderer, camera, scene) => {
        checkReplacement()
        addMissingWeights(mesh)
        this.prepareIn(scene, renderer, camera, mesh)
      }),
    )
  }

  cloneMaterial(): Material | Material[] {
    this.checkInUse('cloneMaterial')
    return this.material.cloneAll()
  }

  cloneSurface(): Material {
    this.checkInUse('cloneSurface')
    return this.material.clone()
  }

  /**
   * Replaces the drivers.
   *
   * @param options where drivers read their inputs; omitted options keep their values.
   * @param isLate whether inputs are looked up in the first frame instead of now, because they may not exist yet.
   */
  drive(drivers: readonly WrinkleDriver[] | DriverPlan, options?: InputOptions, isLate = false): void {
    this.checkInUse('setDrivers')
    const plan = 'areaNames' in drivers ? drivers : planDrivers(drivers)
    const muscles = driversOf('muscle', plan.drivers)
    for (const mesh of this.meshes) addMuscles(mesh, muscles)
    const all = { ...this.#inputOptions, ...options }
    this.setPlan(plan, (inputs) => bindInputs(this, inputs, this.renderer.bindTension, all), isLate)
    this.#inputOptions = all
    this.vrmExpressions = all.vrmExpressions ?? []
  }

  replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    this.resume()
    const { textures } = this.shaderInputs
    checkAreas(areas, textures.layers, who)
    const array = createAreaArray(areas, textures.layers, this.options.areaSize, who)
    exchangeAreas(this.shaderInputs, array)
    this.areas = copyAreas(areas)
    this.rebind(array, areas)
    exposeAreas(this.mesh, this)
    // Rebuilds the shader graph of the mode `paper`, which references the old array.
    if (this.mode === 'paper') this.material.show('paper')
  }

  /** Uses the drivers of a set or of another mesh. A copied mesh may get its skeleton later, so its inputs are looked up in the first frame. */
  #driveAs(source: WrinkleSet<ArraySlice> | WrinkledMesh): void {
    if (source instanceof WrinkledMesh) {
      const { targetsOf, vrmExpressions } = source.#inputOptions
      if (source.plan) this.drive(source.plan, { targetsOf, vrmExpressions }, true)
      return
    }
    const { drivers } = source as { drivers?: readonly WrinkleDriver[] }
    if (drivers) applyDrivers(drivers, 'Wrinkles', () => this.drive(drivers))
  }
}

/** Copies the areas, because changes of the copies must not change the wrinkle set. */
function copyAreas(areas: readonly Area<ArraySlice>[]): Area<ArraySlice>[] {
  return areas.map((area) => ({ ...area }))
}
