import { type Camera, type Material, type Mesh, REVISION, type Scene } from 'three'
import { wrongArgument } from '../core/argument.ts'
import { checkAreas } from '../core/check-areas.ts'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { driversOf } from '../drivers/of-type.ts'
import { type DriverPlan, planDrivers } from '../drivers/plan.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { applyDrivers } from '../runtime/apply-drivers.ts'
import type { Cell } from '../runtime/atlas-cells.ts'
import { FaceGroup } from '../runtime/face-group.ts'
import type { FrameEntry, FrameMember } from '../runtime/frame.ts'
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
  exchangeAreas,
  locateCells,
  releaseShaderInputs,
  retainShaderInputs,
  type ShaderInputs,
} from './material/shader-inputs.ts'
import { watchReplacement } from './material/watch-replacement.ts'
import { createTextures } from './material/wrinkle-textures.ts'
import { callBeforeRender, isPrepared } from './mesh/before-render.ts'
import { checkIsMesh, checkMesh } from './mesh/check-mesh.ts'
import { countFaces, instancesOf } from './mesh/instances.ts'
import { type MeshPlace, placeOf } from './mesh/mesh-place.ts'
import {
  checkMode,
  checkOptions,
  WRINKLES_DEFAULTS,
  type WrinkleMode,
  type WrinklesOptions,
} from './options.ts'
import { LazyRelief } from './relief/lazy-relief.ts'
import type { RaisedFace } from './relief/raised-face.ts'
import { type AnyRenderer, checkRenderer, isRefused } from './renderer.ts'
import { bindInputs } from './sources/bind-inputs.ts'
import { addMuscles } from './sources/muscles.ts'
import type { InputOptions } from './sources/target.ts'
import { checkThree } from './three-version.ts'

/** A mesh that shows wrinkles: everything behind `Wrinkles`, out of users' reach. */
export class WrinkledMesh extends FaceGroup<AnyRenderer> implements FrameMember<AnyRenderer>, RaisedFace {
  readonly mesh: Mesh
  readonly meshes: Mesh[] = []
  readonly place: MeshPlace
  readonly shaderInputs: ShaderInputs
  readonly material: PatchedMaterial
  readonly relief: LazyRelief
  readonly options: Required<WrinklesOptions>
  readonly #renderer: RendererParts
  readonly #frame: RendererFrame
  #entry: FrameEntry<AnyRenderer>
  readonly #atlas: InfluenceAtlas
  #cells: readonly Cell[]
  /** Whether the page has disposed of the material, and drawn no mesh since. */
  #isSuspended = false
  #appearance: Appearance | null = null
  #inputOptions: InputOptions = {}

  /**
   * @param renderer what depends on the renderer.
   * @param source a checked set, or another mesh: its areas, textures and drivers are used, with activations at rest.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
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
    super(countFaces(mesh), shared ? given : copyAreas(given), areas)
    this.mesh = mesh
    this.#renderer = renderer
    this.options = all
    this.#frame = frameOf(renderer.quads)
    this.#atlas = this.#frame.atlasFor(areas.width, areas.height, layers.length)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    this.shaderInputs = createShaderInputs(textures, areas, this.#atlas, instancesOf(mesh) !== null)
    this.material = new PatchedMaterial(
      this.meshes,
      material,
      this.shaderInputs,
      renderer,
      (by) => this.#frame.compileLater(this.#atlas, by),
      () => this.#suspend(),
    )
    this.place = placeOf(mesh)
    this.relief = new LazyRelief(this, renderer.loadRelief)
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

  get mode(): WrinkleMode {
    return this.material.mode
  }

  /** @throws FurrowError when the mode is not possible; it then stays as it was. */
  set mode(mode: WrinkleMode) {
    this.checkInUse('mode')
    checkMode(mode)
    if (mode === this.mode) return
    this.material.show(mode)
    this.relief.resume()
  }

  /** Updates inputs, drivers and activations now; influence is drawn only with a renderer. */
  update(renderer: AnyRenderer | null): void {
    this.checkInUse('update')
    if (renderer !== null && typeof renderer?.render !== 'function') {
      throw wrongArgument('Wrinkles.update', 'a renderer', renderer, 'one of three.js, or null')
    }
    if (renderer) {
      checkRenderer(renderer, this.#renderer.entry, 'Wrinkles')
      this.#resume()
    }
    this.#frame.update(this.#entry, renderer)
  }

  /** @throws FurrowError when no area has that name. */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    this.checkInUse('createInfluenceMaterial')
    this.#resume()
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
        this.prepareIn(scene, renderer, camera, mesh)
      }),
    )
  }

  cloneMaterial(): Material | Material[] {
    this.checkInUse('cloneMaterial')
    return this.material.cloneAll()
  }

  /** Copies the one material that shows the wrinkles, without them. */
  cloneSurface(): Material {
    this.checkInUse('cloneSurface')
    return this.material.clone()
  }

  /**
   * Replaces the drivers.
   *
   * @param options where their inputs are found; those left out stay as they were.
   * @param isLate whether inputs are found at the first frame: they may not exist before.
   */
  drive(drivers: readonly WrinkleDriver[] | DriverPlan, options?: InputOptions, isLate = false): void {
    this.checkInUse('setDrivers')
    const plan = 'areaNames' in drivers ? drivers : planDrivers(drivers)
    const muscles = driversOf('muscle', plan.drivers)
    for (const mesh of this.meshes) addMuscles(mesh, muscles)
    const all = { ...this.#inputOptions, ...options }
    this.driveBy(plan, (inputs) => bindInputs(this, inputs, this.#renderer.bindTension, all), isLate)
    this.#inputOptions = all
    this.vrmExpressions = all.vrmExpressions ?? []
  }

  /** Lets the wrinkles appear in the next frames. */
  appear(appearance: Appearance): void {
    this.#appearance = appearance
  }

  /** Exchanges the list of areas. */
  replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    this.#resume()
    const { textures } = this.shaderInputs
    checkAreas(areas, textures.layers, who)
    const array = createAreaArray(areas, textures.layers, this.options.areaSize, who)
    exchangeAreas(this.shaderInputs, array)
    this.areas = copyAreas(areas)
    this.#atlas.rebind(this.#cells, array, areas)
    exposeAreas(this.mesh, this)
    // The shader graph of the paper's mode holds the array itself.
    if (this.mode === 'paper') this.material.show('paper')
  }

  /** Called when another face joins: the shader may have been made for one that is alone in the influence map. */
  refresh(): void {
    this.material.settle(null)
  }

  /** Called before a mesh is drawn in a scene. */
  prepareIn(scene: Scene, renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    this.#entry.isLate ||= isPrepared(mesh)
    if (!this.prepare(renderer, camera, mesh, Boolean(scene.overrideMaterial))) return
    this.#frame.noteScene(scene, this.#entry, renderer)
  }

  /**
   * Called before a mesh is drawn: brings the material up to date, runs the phases up to the influence, then sets what the mesh's shader reads.
   *
   * @param isOverridden whether the scene's material draws it, as a shadow's does: on `WebGPURenderer` in the midst of the mesh's own draw.
   * @returns whether the phases ran.
   */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh, isOverridden = false): boolean {
    if (this.isDisposed || this.#renderer.isCompiling?.(renderer)) return false
    if (isRefused(renderer, this.#renderer.entry, 'Wrinkles')) {
      if (this.mode !== 'off') this.mode = 'off'
      return false
    }
    if (this.#isSuspended) {
      if (this.material.isOn(mesh)) this.#resumeLater()
      return false
    }
    this.material.settle(renderer)
    if (!isOverridden) this.shaderInputs.fade.value = this.#fadeOf(mesh, camera, renderer)
    this.#frame.begin(this.#entry, renderer)
    locateCells(this.shaderInputs, this.#atlas, this.#cells)
    // After the drivers: relief by size depends on activations.
    this.relief.prepare(renderer, camera, mesh)
    return true
  }

  /** Phase 4 of a frame, see `Frame`. */
  collectInfluence(renderer: AnyRenderer): boolean {
    const { fade, areas, textures } = this.shaderInputs
    areas.upload?.(renderer)
    textures.upload?.(renderer)
    const { mode, views } = this.material
    const isUsed = mode === 'default' || mode === 'composed' || views > 0 || this.relief.isShown
    if (fade.value === 0 || !isUsed) return false
    this.#atlas.collect(this.#cells, renderer)
    return true
  }

  /** Phase 5: the composed normal map and the paper's table, in their modes. */
  composeNormals(renderer: AnyRenderer): void {
    const { update } = this.material
    if (!update) return
    locateCells(this.shaderInputs, this.#atlas, this.#cells)
    update(renderer, this.faces[0].activations)
  }

  override dispose(): void {
    if (this.isDisposed) return
    this.relief.dispose()
    super.dispose()
    this.material.dispose()
    if (!this.#isSuspended) this.#leave()
  }

  /** Frees everything on the GPU until a mesh is drawn again. */
  #suspend(): void {
    if (this.#isSuspended) return
    this.#isSuspended = true
    this.relief.suspend()
    this.material.suspend()
    this.#leave()
    this.release()
  }

  /**
   * Takes part in frames again after this one: a new cell may take a larger atlas, and the frame reads the old one. A separate method, since
   * closures allocate in every call.
   */
  #resumeLater(): void {
    queueMicrotask(() => this.#resume())
  }

  /** Takes part in frames again. Not to be called during a frame. */
  #resume(): void {
    if (this.isDisposed || !this.#isSuspended) return
    this.#isSuspended = false
    this.#frame.restore(this.#atlas)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    retainShaderInputs(this.shaderInputs)
    this.material.resume()
  }

  /** Leaves the frames, and frees everything that no other face uses. */
  #leave(): void {
    this.#frame.remove(this.#entry)
    this.#atlas.remove(this.#cells)
    this.#frame.release(this.#atlas)
    releaseShaderInputs(this.shaderInputs)
  }

  /** 1 = not faded, 0 = the mesh is too small on screen to show wrinkles, or they have not appeared yet. */
  #fadeOf(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
    const appeared = this.#appearance?.advance(this.clock) ?? 1
    const { fadeBelow } = this.options
    if (fadeBelow === 0 || this.mode === 'composed' || instancesOf(this.mesh)) return appeared
    return appeared * fadeOnScreen(mesh, camera, renderer, fadeBelow)
  }

  /** Takes the drivers of a set or of another mesh. A copy may get its skeleton later, and does not show the expressions of a VRM. */
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

/** The faces that use one array of areas have one list of them, which changes with it. */
function copyAreas(areas: readonly Area<ArraySlice>[]): Area<ArraySlice>[] {
  return areas.map((area) => ({ ...area }))
}
