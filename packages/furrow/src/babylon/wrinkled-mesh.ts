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
import { FaceGroup } from '../runtime/face-group.ts'
import { checkIsMesh, checkMaterial, checkMesh } from './check-mesh.ts'
import { checkMode, checkOptions, type WrinkleMode, type WrinklesOptions } from './options.ts'
import { patchMaterial } from './patched-material.ts'
import { type SceneMember, sceneFrame } from './scene-frame.ts'
import { SharedSet } from './shared-set.ts'
import { bindInputs } from './sources/bind-inputs.ts'
import { addMuscles } from './sources/muscles.ts'
import { CELL, type DrawnFace, WrinklePlugin } from './wrinkle-plugin.ts'

const facesByMesh = new WeakMap<AbstractMesh, WrinkledMesh>()

/** Returns the wrinkles of a mesh, or undefined. If the mesh is a copy that was made since the last frame, adds its wrinkles first. */
export function wrinklesOfMesh(mesh: AbstractMesh): WrinkledMesh | undefined {
  const source = (mesh as InstancedMesh).sourceMesh
  if (!facesByMesh.has(mesh) && source) facesByMesh.get(source)?.adopt()
  return facesByMesh.get(mesh) ?? adoptClone(mesh)
}

/** Maps each clone that has no wrinkles yet to the wrinkles of its source. The clone gets wrinkles before the next frame. */
const copies = new Map<AbstractMesh, WrinkledMesh>()

function adoptClone(mesh: AbstractMesh): WrinkledMesh | undefined {
  copies.get(mesh)?.adopt()
  return facesByMesh.get(mesh)
}

/** Internal state of `Wrinkles`: the meshes, areas and drivers of one face. `WrinklesBase` documents the methods and their errors. */
export class WrinkledMesh extends FaceGroup<Scene> implements SceneMember, DrawnFace {
  readonly mesh: AbstractMesh
  readonly shared: SharedSet
  readonly cells: readonly Cell[]
  readonly #meshes: AbstractMesh[] = []
  readonly #options: Required<WrinklesOptions>
  readonly #unpatch = new Map<AbstractMesh, () => void>()
  #mode: WrinkleMode = 'off'
  /** Whether instances have the `furrowCell` attribute. */
  hasCells = false

  /**
   * Adds wrinkles to a mesh. Replaces existing wrinkles of the mesh.
   *
   * @param source a checked wrinkle set, or the wrinkles of another mesh, which then share their set, textures and drivers with this mesh.
   * @throws FurrowError if the mesh or its material is unsupported. The mesh is then unchanged.
   */
  constructor(
    mesh: AbstractMesh,
    source: WrinkleSet<ArraySlice> | WrinkledMesh,
    options: WrinklesOptions = {},
  ) {
    const isCopy = source instanceof WrinkledMesh
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
    // The plan is read now, because `source` may be the existing wrinkles of `mesh`, which are disposed below.
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

  get mode(): WrinkleMode {
    return this.#mode
  }

  set mode(mode: WrinkleMode) {
    this.checkInUse('mode')
    checkMode(mode)
    if (mode === 'default') for (const mesh of this.#meshes) this.#patch(mesh)
    else this.#unpatchAll()
    this.#mode = mode
  }

  addMesh(mesh: AbstractMesh): void {
    this.checkInUse('addMesh')
    checkIsMesh(mesh, 'Wrinkles.addMesh')
    if (this.#mode === 'default') this.#patch(mesh)
    addMuscles(mesh, driversOf('muscle', this.drivers))
    this.#meshes.push(mesh)
    facesByMesh.set(mesh, this)
    const cloned = mesh.onClonedObservable.add((copy) => copies.set(copy as AbstractMesh, this))
    const disposed = mesh.onDisposeObservable.add(() => this.dispose())
    if (this.faces.length > 1 || isInstance(mesh)) this.#writeCells(mesh)
    this.onDispose(() => {
      mesh.onClonedObservable.remove(cloned)
      mesh.onDisposeObservable.remove(disposed)
      if (facesByMesh.get(mesh) === this) facesByMesh.delete(mesh)
    })
  }

  update(scene: Scene | null): void {
    this.checkInUse('update')
    sceneFrame(this.shared.scene).run(this, scene)
  }

  /**
   * Replaces the drivers.
   *
   * @param isLate whether to bind inputs in the next frame instead of now.
   */
  drive(drivers: readonly WrinkleDriver[] | DriverPlan, isLate = false): void {
    this.checkInUse('setDrivers')
    const plan = 'areaNames' in drivers ? drivers : planDrivers(drivers)
    const muscles = driversOf('muscle', plan.drivers)
    for (const mesh of this.#meshes) addMuscles(mesh, muscles)
    this.setPlan(plan, (inputs) => bindInputs(this, inputs), isLate)
  }

  override dispose(): void {
    if (this.isDisposed) return
    super.dispose()
    this.#unpatchAll()
    sceneFrame(this.shared.scene).leave(this)
    this.shared.atlas.cells.remove(this.cells)
    for (const [copy, source] of copies) if (source === this) copies.delete(copy)
    this.shared.release()
  }

  get isShown(): boolean {
    return this.#mode === 'default' && this.mesh.isEnabled()
  }

  /** Adds wrinkles to those clones and instances that have none. */
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

  /** Runs phase 4 of a frame: tells the atlas which cells have changed. `Frame` documents the phases. */
  collectInfluence(): boolean {
    if (this.#mode === 'off') return false
    this.shared.atlas.cells.collect(this.cells)
    return true
  }

  /** Does nothing, because Furrow has no `composed` mode in Babylon.js. */
  composeNormals(): void {}

  #copyTo(copy: AbstractMesh): void {
    if (copy.isDisposed() || facesByMesh.has(copy)) return
    try {
      new WrinkledMesh(copy, this)
    } catch (error) {
      // A copy whose material is unsupported is drawn without wrinkles.
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

  /** Writes the index of each instance's cell to a vertex attribute. */
  #writeCells(mesh: AbstractMesh): void {
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

  markInstanced(): void {
    if (this.hasCells) return
    this.hasCells = true
    for (const mesh of this.#meshes) {
      mesh.material?.pluginManager?.getPlugin<WrinklePlugin>(WrinklePlugin.NAME)?.markAllDefinesAsDirty()
    }
  }
}

/** Returns the wrinkles of a mesh, or undefined if there are none or their mode is `off`. */
function shownOn(mesh: AbstractMesh): WrinkledMesh | undefined {
  const face = facesByMesh.get(mesh)
  return face?.mode === 'default' ? face : undefined
}

function isInstance(mesh: AbstractMesh): mesh is InstancedMesh {
  return mesh.isAnInstance
}
