import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { InstancedMesh } from '@babylonjs/core/Meshes/instancedMesh.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import '@babylonjs/core/Meshes/thinInstanceMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { driversOf } from '../drivers/of-type.ts'
import { type DriverPlan, planDrivers } from '../drivers/plan.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { applyDrivers } from '../runtime/apply-drivers.ts'
import type { Cell } from '../runtime/atlas-cells.ts'
import { WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import { checkIsMesh, checkMaterial, checkMesh } from './check-mesh.ts'
import { checkMode, checkOptions, type WrinkleMode, type WrinklesOptions } from './options.ts'
import { patchMaterial } from './patched-material.ts'
import { sceneFrame } from './scene-frame.ts'
import { SharedSet } from './shared-set.ts'
import { bindInputs } from './sources/bind-inputs.ts'
import { addMuscles } from './sources/muscles.ts'
import { CELL, WrinklePlugin } from './wrinkle-plugin.ts'

const facesByMesh = new WeakMap<AbstractMesh, WrinklesBase>()

/** The wrinkles of a mesh, or undefined. A copy that was made since the last frame gets its own now. */
export function addedTo(mesh: AbstractMesh): WrinklesBase | undefined {
  const source = (mesh as InstancedMesh).sourceMesh
  if (!facesByMesh.has(mesh) && source) facesByMesh.get(source)?.adopt()
  return facesByMesh.get(mesh) ?? adoptedLater(mesh)
}

/** Copies that the page has made of meshes with wrinkles, which get their own before the next frame. */
const copies = new Map<AbstractMesh, WrinklesBase>()

function adoptedLater(mesh: AbstractMesh): WrinklesBase | undefined {
  copies.get(mesh)?.adopt()
  return facesByMesh.get(mesh)
}

/**
 * Wrinkles on one mesh, on an instance of one, or on each of its thin instances: what `registerWrinkleMaps` adds to loaded files, and the
 * base of `Wrinkles`. The material remains the user's, and `dispose` restores it. Copies of the mesh, by `clone`, `createInstance` or
 * `instantiateModelsToScene`, get wrinkles of their own before they are first drawn.
 */
export class WrinklesBase extends WrinkleFaces<Scene> {
  /** The mesh that drives: its blendshapes, skeleton and surface are measured. */
  readonly mesh: AbstractMesh
  /** @internal */
  readonly shared: SharedSet
  /** @internal */
  readonly cells: readonly Cell[]
  readonly #meshes: AbstractMesh[] = []
  readonly #options: Required<WrinklesOptions>
  readonly #unpatch = new Map<AbstractMesh, () => void>()
  #mode: WrinkleMode = 'off'
  #hasCells = false

  /**
   * @param mesh with UVs whose v points down, as in glTF, normals, and a `PBRMaterial` or `StandardMaterial`.
   * @param source a wrinkle set, copied. Or the wrinkles of another mesh, whose set, textures and drivers are used, with activations at rest; or
   *   those of the mesh itself, which are replaced, as after a change of its thin instances.
   * @throws FurrowError when the mesh or its material does not fit; the mesh is then unchanged.
   */
  constructor(
    mesh: AbstractMesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options: WrinklesOptions = {},
  ) {
    const isCopy = source instanceof WrinklesBase
    const all = checkOptions(isCopy ? { ...source.#options, ...options } : options, 'Wrinkles')
    checkMesh(mesh)
    const { material } = checkMaterial(mesh)
    if (isCopy) source.checkInUse('set')
    const shared = isCopy
      ? source.shared
      : new SharedSet(
          source as WrinkleSet,
          all.areaSize,
          material.bumpTexture?.anisotropicFilteringLevel ?? 4,
          mesh.getScene(),
        )
    // Read before the wrinkles of the same mesh are disposed of.
    const plan = isCopy ? source.plan : undefined
    super(Math.max((mesh as Mesh).thinInstanceCount ?? 0, 1), shared.areas, shared.slices)
    this.mesh = mesh
    this.shared = shared
    this.#options = all
    shared.retain()
    this.cells = shared.atlas.add(this.faces)
    facesByMesh.get(mesh)?.dispose()
    sceneFrame(shared.scene).join(this)
    try {
      this.addMesh(mesh)
      this.mode = all.mode
      const { drivers } = source
      if (plan) this.drive(plan, true)
      else if (drivers)
        applyDrivers(drivers as readonly WrinkleDriver[], 'Wrinkles', () => this.drive(drivers))
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  /** How wrinkles are shown. */
  get mode(): WrinkleMode {
    return this.#mode
  }

  /**
   * Changes how wrinkles are shown.
   *
   * @throws FurrowError when Babylon.js has no such mode, or the material shows another set; the mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    this.checkInUse('mode')
    checkMode(mode)
    if (mode === 'default') for (const mesh of this.#meshes) this.#patch(mesh)
    else this.#unpatchAll()
    this.#mode = mode
  }

  /** Number of faces: thin instances, or 1 for any other mesh. */
  get faceCount(): number {
    return this.faces.length
  }

  /**
   * Adds another mesh, such as a second primitive of the face. It shows the same wrinkles.
   *
   * @throws FurrowError when its material cannot, or shows those of another set.
   */
  addMesh(mesh: AbstractMesh): void {
    this.checkInUse('addMesh')
    checkIsMesh(mesh, 'Wrinkles.addMesh')
    if (this.#mode === 'default') this.#patch(mesh)
    this.#meshes.push(mesh)
    facesByMesh.set(mesh, this)
    const cloned = mesh.onClonedObservable.add((copy) => copies.set(copy as AbstractMesh, this))
    const disposed = mesh.onDisposeObservable.add(() => this.dispose())
    if (this.faceCount > 1 || isInstance(mesh)) this.#tellCells(mesh)
    this.onDispose(() => {
      mesh.onClonedObservable.remove(cloned)
      mesh.onDisposeObservable.remove(disposed)
      if (facesByMesh.get(mesh) === this) facesByMesh.delete(mesh)
    })
  }

  /**
   * Updates inputs, drivers and activations now. Every frame does so before it is drawn; this is for tests, and for pages that read
   * activations without drawing.
   *
   * @param scene that of the mesh, to draw the influence maps too.
   */
  update(scene: Scene | null = null): void {
    this.checkInUse('update')
    sceneFrame(this.shared.scene).run(this, scene)
  }

  /**
   * Replaces the drivers.
   *
   * @param isLate whether their inputs are found at the first frame.
   * @internal
   */
  drive(drivers: readonly WrinkleDriver[] | DriverPlan, isLate = false): void {
    this.checkInUse('setDrivers')
    const plan = 'areaNames' in drivers ? drivers : planDrivers(drivers)
    const muscles = driversOf('muscle', plan.drivers)
    for (const mesh of this.#meshes) addMuscles(mesh, muscles)
    this.driveBy(plan, (inputs) => bindInputs(this, inputs), isLate)
  }

  /** Frees what no other face uses, and restores the material. */
  override dispose(): void {
    if (this.isDisposed) return
    super.dispose()
    this.#unpatchAll()
    sceneFrame(this.shared.scene).leave(this)
    this.shared.atlas.cells.remove(this.cells)
    for (const [copy, source] of copies) if (source === this) copies.delete(copy)
    this.shared.release()
  }

  /** @internal */
  get hasCells(): boolean {
    return this.#hasCells
  }

  /** @internal */
  get isShown(): boolean {
    return this.#mode === 'default' && this.mesh.isEnabled()
  }

  /** Gives copies of the meshes wrinkles of their own. @internal */
  adopt(): void {
    for (const [copy, source] of copies) {
      if (source !== this) continue
      copies.delete(copy)
      this.#copyTo(copy)
    }
    for (const mesh of this.#meshes) {
      for (const instance of (mesh as Mesh).instances ?? [])
        if (!facesByMesh.has(instance)) this.#copyTo(instance)
    }
  }

  /** Phase 4 of a frame, see `Frame`. @internal */
  collectInfluence(): boolean {
    if (this.#mode === 'off') return false
    this.shared.atlas.cells.collect(this.cells)
    return true
  }

  /** Phase 5: nothing is derived from the influence. @internal */
  composeNormals(): void {}

  #copyTo(copy: AbstractMesh): void {
    if (copy.isDisposed() || facesByMesh.has(copy)) return
    try {
      new WrinklesBase(copy, this)
    } catch (error) {
      // A copy with another material stays plain.
      console.warn((error as Error).message)
    }
  }

  #patch(mesh: AbstractMesh): void {
    if (this.#unpatch.has(mesh)) return
    const { material, kind } = checkMaterial(mesh)
    this.#unpatch.set(
      mesh,
      patchMaterial(material, kind, this.shared, (drawn) => shownOn(drawn)),
    )
  }

  #unpatchAll(): void {
    for (const unpatch of this.#unpatch.values()) unpatch()
    this.#unpatch.clear()
  }

  /** Tells the vertices of a mesh's instances which cells are theirs. */
  #tellCells(mesh: AbstractMesh): void {
    const source = isInstance(mesh) ? mesh.sourceMesh : (mesh as Mesh)
    const first = this.cells[0].index
    if (isInstance(mesh)) {
      const owner = facesByMesh.get(source)
      if (!source.instancedBuffers?.[CELL]) {
        source.registerInstancedBuffer(CELL, 1)
        source.instancedBuffers[CELL] = owner?.cells[0].index ?? first
      }
      mesh.instancedBuffers[CELL] = first
      owner?.markInstanced()
    } else {
      source.thinInstanceSetBuffer(
        CELL,
        Float32Array.from(this.cells, ({ index }) => index),
        1,
        true,
      )
      this.markInstanced()
    }
  }

  /** @internal */
  markInstanced(): void {
    if (this.#hasCells) return
    this.#hasCells = true
    for (const mesh of this.#meshes) {
      mesh.material?.pluginManager?.getPlugin<WrinklePlugin>(WrinklePlugin.NAME)?.markAllDefinesAsDirty()
    }
  }
}

/** The face that a mesh shows, if it does. */
function shownOn(mesh: AbstractMesh): WrinklesBase | undefined {
  const face = facesByMesh.get(mesh)
  return face?.mode === 'default' ? face : undefined
}

function isInstance(mesh: AbstractMesh): mesh is InstancedMesh {
  return mesh.isAnInstance
}
