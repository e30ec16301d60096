import { type Camera, type Material, type Mesh, REVISION, type Scene } from 'three'
import { wrongArgument } from '../core/argument.ts'
import { checkAreas } from '../core/check-areas.ts'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { driversOf } from '../drivers/of-type.ts'
import { type DriverPlan, planDrivers } from '../drivers/plan.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { applyDrivers } from '../runtime/apply-drivers.ts'
import type { Cell } from '../runtime/atlas-cells.ts'
import type { FrameEntry } from '../runtime/frame.ts'
import { WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import { noteAdded } from './added-to.ts'
import { exposeAreas } from './animated-areas.ts'
import type { Appearance } from './appearance.ts'
import { createAreaArray } from './atlas/area-array.ts'
import type { InfluenceAtlas } from './atlas/influence-atlas.ts'
import { fadeOnScreen } from './camera/size-on-screen.ts'
import { frameOf, type RendererFrame } from './frame.ts'
import { checkMaterial } from './material/check-material.ts'
import { PatchedMaterial } from './material/patched-material.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import {
  createShaderInputs,
  disposeShaderInputs,
  exchangeAreas,
  locateCells,
  type ShaderInputs,
} from './material/shader-inputs.ts'
import { createTextures } from './material/wrinkle-textures.ts'
import { callBeforeRender, isPrepared } from './mesh/before-render.ts'
import { checkIsMesh, checkMesh } from './mesh/check-mesh.ts'
import { countFaces, instancesOf } from './mesh/instances.ts'
import { type MeshPlace, placeOf } from './mesh/mesh-place.ts'
import {
  checkMode,
  checkOptions,
  checkReliefMode,
  type ReliefMode,
  WRINKLES_DEFAULTS,
  type WrinkleMode,
  type WrinklesOptions,
} from './options.ts'
import { canRise } from './relief/raised-layer.ts'
import type { ReliefControl } from './relief/relief-control.ts'
import { type AnyRenderer, checkRenderer, isRefused } from './renderer.ts'
import { bindInputs } from './sources/bind-inputs.ts'
import { addMuscles } from './sources/muscles.ts'
import type { InputOptions } from './sources/target.ts'
import { checkThree } from './three-version.ts'

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`: the base of both renderers' `Wrinkles`. The
 * material remains the user's: morphs, skinning, shadows, environment and `normalScale` keep working, and `dispose` restores it.
 */
export abstract class WrinklesBase extends WrinkleFaces<AnyRenderer> {
  /** The mesh that drives: its blendshapes, skeleton and surface are measured. */
  readonly mesh: Mesh
  readonly #renderer: RendererParts
  readonly #options: Required<WrinklesOptions>
  readonly #frame: RendererFrame
  readonly #entry: FrameEntry<AnyRenderer>
  readonly #atlas: InfluenceAtlas
  readonly #cells: readonly Cell[]
  readonly #inputs: ShaderInputs
  readonly #material: PatchedMaterial
  readonly #meshes: Mesh[] = []
  /** Where the mesh was when the wrinkles were added, for relief. */
  readonly #place: MeshPlace
  #reliefMode: ReliefMode = 'off'
  /** Null until relief is wanted, and there are heights for it. */
  #relief: ReliefControl | null = null
  #appearance: Appearance | null = null
  #inputOptions: InputOptions = {}

  /**
   * @param renderer what depends on the renderer.
   * @param mesh with UVs, normals, and a lit material of its own.
   * @param source a wrinkle set, copied: later changes have no effect, use `addArea`, `removeArea`, `updateArea` and `updateLayer`. Or the wrinkles of
   *   another mesh, whose set, textures and drivers are used, with activations at rest.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(
    renderer: RendererParts,
    mesh: Mesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options: WrinklesOptions = {},
  ) {
    checkThree(renderer.entry, REVISION)
    let inputs: ShaderInputs | undefined
    let own: WrinklesOptions | undefined
    if (source instanceof WrinklesBase) {
      source.checkInUse('set')
      inputs = source.#inputs
      own = source.#options
    }
    // Both have areas; the layers of other wrinkles are those of their textures.
    const { areas: given, layers = inputs!.textures.layers } = source as WrinkleSet<ArraySlice>
    const allOptions = { ...WRINKLES_DEFAULTS, ...own, ...options }
    checkOptions(allOptions, 'Wrinkles')
    checkMesh(mesh)
    const material = checkMaterial(mesh)
    const areas = inputs?.areas ?? createAreaArray(given, layers, allOptions.areaSize, 'Wrinkles')
    const textures = inputs?.textures ?? createTextures(layers, material.normalMap?.anisotropy ?? 1)
    super(countFaces(mesh), inputs ? given : copyAreas(given), areas)
    this.mesh = mesh
    this.#renderer = renderer
    this.#options = allOptions
    this.#frame = frameOf(renderer.quads)
    this.#atlas = this.#frame.atlasFor(areas.width, areas.height, layers.length)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    this.#inputs = createShaderInputs(textures, areas, this.#atlas, instancesOf(mesh) !== null)
    this.#material = new PatchedMaterial(this.#meshes, material, this.#inputs, renderer, (own) =>
      // Also after a first frame without wrinkles, so that the first one with them waits for no program. Not within `compile`, whose lights
      // another call of it would take.
      queueMicrotask(() => this.isDisposed || this.#atlas.compile(own)),
    )
    if (this.#inputs.isAlone()) this.#atlas.onShared = () => this.#material.share()
    this.#place = placeOf(mesh)
    this.addMesh(mesh)
    this.relief = allOptions.relief
    try {
      this.mode = allOptions.mode
      this.#driveAs(source)
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  /** How wrinkles are shown. */
  get mode(): WrinkleMode {
    return this.#material.mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is recompiled. The composed mode shows normals only, and does not fade.
   *
   * @throws FurrowError when the mode is not possible: `paper` with more than one layer, or with maps of the material that
   *   cannot be read or differ in size; `paper` and `composed` for instances; `paper` for a material that cannot be patched. The mode then
   *   stays as it was.
   */
  set mode(mode: WrinkleMode) {
    this.checkInUse('mode')
    checkMode(mode)
    if (mode === this.mode) return
    this.#material.show(mode)
    this.#relief?.resume()
  }

  /** Whether the layers' heights move the surface. */
  get relief(): ReliefMode {
    return this.#reliefMode
  }

  /**
   * Changes whether the layers' heights move the surface. Triangles under areas are split when that is first wanted, in slices: the page
   * goes on, and shows the face without relief until then. Meshes that cannot have relief stay as they are; `on` warns of it, once.
   *
   * @throws FurrowError when there is no such value.
   */
  set relief(mode: ReliefMode) {
    this.checkInUse('relief')
    checkReliefMode(mode)
    this.#reliefMode = mode
    if (this.#relief) this.#relief.mode = mode
    else if (mode !== 'off') this.#fetchRelief().catch(({ message }) => console.warn(message))
  }

  /** Splits the triangles for relief now, where there are heights; fulfilled when it can be drawn. */
  async reliefReady(): Promise<void> {
    this.checkInUse('reliefReady')
    await (await this.#fetchRelief())?.ready()
  }

  /** Number of faces: instances, or 1 for any other mesh. */
  get faceCount(): number {
    return this.faces.length
  }

  /**
   * Updates inputs, drivers and activations now. Every frame does so before it is drawn; this is for tests, and for pages that read
   * activations without drawing.
   *
   * @param renderer also draws the influence maps. Without one, inputs that only a renderer can measure keep their last value.
   */
  update(renderer: AnyRenderer | null = null): void {
    this.checkInUse('update')
    if (renderer !== null && typeof renderer?.render !== 'function') {
      throw wrongArgument('Wrinkles.update', 'a renderer', renderer, 'one of three.js, or null')
    }
    if (renderer) checkRenderer(renderer, this.#renderer.entry, 'Wrinkles')
    this.#frame.update(this.#entry, renderer)
  }

  /**
   * Creates a material that shows influence as gray on the moving mesh, black = none, white = 1: the current influence, or the weights
   * of some areas, whatever their activations. Dispose of it after use, and create it again after areas were added or removed.
   *
   * @param area name or names; by default, the current influence.
   *
   * @throws FurrowError when no area has that name.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    this.checkInUse('createInfluenceMaterial')
    if (area === undefined) return this.#material.influenceMaterial()
    const names = [area].flat()
    for (const name of names) this.getActivation(name)
    return this.#material.influenceMaterial({ areas: this.areas, names })
  }

  /**
   * Adds another mesh with the same material, such as a second primitive of the face. It shows the same wrinkles, whichever mesh is
   * drawn first.
   */
  addMesh(mesh: Mesh): void {
    this.checkInUse('addMesh')
    checkIsMesh(mesh, 'Wrinkles.addMesh')
    this.#meshes.push(mesh)
    this.#material.follow(mesh)
    if (mesh === this.mesh) exposeAreas(mesh, this)
    this.onDispose(
      callBeforeRender(mesh, (renderer, camera, scene) => this.prepareIn(scene, renderer, camera, mesh)),
    )
    this.onDispose(noteAdded(mesh, this))
  }

  /**
   * Copies the material without its wrinkles, for another mesh with wrinkles of its own; of a mesh with several materials a list, in which
   * the others are the same.
   */
  cloneMaterial(): Material | Material[] {
    this.checkInUse('cloneMaterial')
    return this.#material.cloneAll()
  }

  /** Copies the one material that shows the wrinkles, without them. @internal */
  cloneSurface(): Material {
    this.checkInUse('cloneSurface')
    return this.#material.clone()
  }

  /** Data that `addArea`, `updateArea` and `updateLayer` change: this and all faces with the same textures. @internal */
  editable(method: string): { areas: Area<ArraySlice>[]; inputs: ShaderInputs } {
    this.checkInUse(method)
    return { areas: this.areas, inputs: this.#inputs }
  }

  /**
   * Replaces the drivers.
   *
   * @param options where their inputs are found; those left out stay as they were.
   * @param isLate whether inputs are found at the first frame: they may not exist before.
   * @internal
   */
  drive(drivers: readonly WrinkleDriver[] | DriverPlan, options?: InputOptions, isLate = false): void {
    this.checkInUse('setDrivers')
    const plan = 'areaNames' in drivers ? drivers : planDrivers(drivers)
    const muscles = driversOf('muscle', plan.drivers)
    for (const mesh of this.#meshes) addMuscles(mesh, muscles)
    const all = { ...this.#inputOptions, ...options }
    this.driveBy(plan, (inputs) => bindInputs(this, inputs, this.#renderer.bindTension, all), isLate)
    this.#inputOptions = all
  }

  /** Lets the wrinkles appear in the next frames. @internal */
  appear(appearance: Appearance): void {
    this.#appearance = appearance
  }

  /** Called before a mesh of a scene is drawn: `prepare`, and what lets the scene's next frame begin before anything is drawn. @internal */
  prepareIn(scene: Scene, renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    this.#entry.isLate ||= isPrepared(mesh)
    if (!this.prepare(renderer, camera, mesh, Boolean(scene.overrideMaterial))) return
    this.#frame.watch(scene, this.#entry, renderer)
  }

  /**
   * Called before a mesh is drawn: runs the phases up to the influence, then sets what the mesh's shader reads.
   *
   * @param isOverridden whether the scene's material draws it, as a shadow's does: on `WebGPURenderer` in the midst of the mesh's own draw.
   * @returns whether the phases ran.
   * @internal
   */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh, isOverridden = false): boolean {
    if (this.isDisposed || this.#renderer.isCompiling?.(renderer)) return false
    if (isRefused(renderer, this.#renderer.entry, 'Wrinkles')) {
      if (this.mode !== 'off') this.mode = 'off'
      return false
    }
    this.#material.settle(renderer)
    if (!isOverridden) this.#inputs.fade.value = this.#fadeOf(mesh, camera, renderer)
    this.#frame.begin(this.#entry, renderer)
    locateCells(this.#inputs, this.#atlas, this.#cells)
    // After the drivers: relief by size depends on activations.
    this.#relief?.prepare(renderer, camera, mesh)
    return true
  }

  /** Phase 4 of a frame, see `Frame`. @internal */
  collectInfluence(renderer: AnyRenderer): boolean {
    const { fade, areas, textures } = this.#inputs
    areas.upload?.(renderer)
    textures.upload?.(renderer)
    const { mode, views } = this.#material
    const isUsed = mode === 'default' || mode === 'composed' || views > 0 || this.#relief?.isShown
    if (fade.value === 0 || !isUsed) return false
    this.#atlas.collect(this.#cells, renderer)
    return true
  }

  /** Phase 5: the composed normal map and the paper's table, in their modes. @internal */
  composeNormals(renderer: AnyRenderer): void {
    const { update } = this.#material
    if (!update) return
    locateCells(this.#inputs, this.#atlas, this.#cells)
    update(renderer, this.faces[0].activations)
  }

  /** Restores the material, and frees the textures that no other face uses. */
  override dispose(): void {
    if (this.isDisposed) return
    this.#relief?.dispose()
    super.dispose()
    this.#frame.remove(this.#entry)
    this.#material.dispose()
    this.#atlas.remove(this.#cells)
    this.#frame.release(this.#atlas)
    disposeShaderInputs(this.#inputs)
  }

  /** 1 = not faded, 0 = the mesh is too small on screen to show wrinkles, or they have not appeared yet. */
  #fadeOf(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
    const appeared = this.#appearance?.advance(this.clock) ?? 1
    const { fadeBelow } = this.#options
    if (fadeBelow === 0 || this.#material.mode === 'composed' || instancesOf(this.mesh)) return appeared
    return appeared * fadeOnScreen(mesh, camera, renderer, fadeBelow)
  }

  /** Takes the drivers of a set or of another face. A copy may get its skeleton later, and does not show the expressions of a VRM. */
  #driveAs(source: WrinkleSet<ArraySlice> | WrinklesBase): void {
    if (source instanceof WrinklesBase) {
      const { targetsOf } = source.#inputOptions
      if (source.plan) this.drive(source.plan, { targetsOf }, true)
      return
    }
    const { drivers } = source as { drivers?: readonly WrinkleDriver[] }
    if (drivers) applyDrivers(drivers, 'Wrinkles', () => this.drive(drivers))
  }

  async #fetchRelief(): Promise<ReliefControl | null> {
    if (!this.#inputs.textures.layers.some(canRise)) return null
    const createRelief = await this.#renderer.loadRelief()
    if (this.isDisposed) return null
    this.#relief ??= createRelief(
      {
        wrinkles: this,
        faces: this.faces,
        meshes: this.#meshes,
        place: this.#place,
        material: this.#material,
        inputs: this.#inputs,
      },
      this.#reliefMode,
    )
    return this.#relief
  }

  /** Exchanges the list of areas, for `addArea` and `removeArea`. @internal */
  replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    const { textures } = this.#inputs
    checkAreas(areas, textures.layers, who)
    const array = createAreaArray(areas, textures.layers, this.#options.areaSize, who)
    exchangeAreas(this.#inputs, array)
    this.areas = copyAreas(areas)
    this.#atlas.rebind(this.#cells, array, areas)
    exposeAreas(this.mesh, this)
    // The shader graph of the paper's mode holds the array itself.
    if (this.mode === 'paper') this.#material.show('paper')
  }
}

/** The faces that use one array of areas have one list of them, which changes with it. */
function copyAreas(areas: readonly Area<ArraySlice>[]): Area<ArraySlice>[] {
  return areas.map((area) => ({ ...area }))
}
