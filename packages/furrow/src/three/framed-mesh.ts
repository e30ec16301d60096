import type { Camera, Mesh, Scene } from 'three'
import { wrongArgument } from '../core/argument.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import type { Cell } from '../runtime/atlas-cells.ts'
import { FaceGroup } from '../runtime/face-group.ts'
import type { FrameEntry, FrameMember } from '../runtime/frame.ts'
import type { Appearance } from './appearance.ts'
import type { AreaArray } from './atlas/area-array.ts'
import type { InfluenceAtlas } from './atlas/influence-atlas.ts'
import { fadeOnScreen } from './camera/size-on-screen.ts'
import { frameOf, type RendererFrame } from './frame.ts'
import { PatchedMaterial } from './material/patched-material.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import {
  createShaderInputs,
  locateCells,
  releaseShaderInputs,
  retainShaderInputs,
  type ShaderInputs,
} from './material/shader-inputs.ts'
import type { WrinkleMaterial } from './material/wrinkle-material.ts'
import type { WrinkleTextures } from './material/wrinkle-textures.ts'
import { isPrepared } from './mesh/before-render.ts'
import { countFaces, instancesOf } from './mesh/instances.ts'
import { type MeshPlace, placeOf } from './mesh/mesh-place.ts'
import { checkMode, type WrinkleMode, type WrinklesOptions } from './options.ts'
import { LazyRelief } from './relief/lazy-relief.ts'
import type { RaisedFace } from './relief/raised-face.ts'
import { type AnyRenderer, checkRenderer, isRefused } from './renderer.ts'

/** A validated mesh with the objects that draw its wrinkles. */
export interface FramedMeshParts {
  renderer: RendererParts
  mesh: Mesh
  material: WrinkleMaterial
  options: Required<WrinklesOptions>
  areas: readonly Area<ArraySlice>[]
  array: AreaArray
  textures: WrinkleTextures
}

/**
 * A mesh with wrinkles, which a `RendererFrame` updates in each frame. Each instance of the mesh has an influence map, which holds in UV space
 * how strongly each layer of wrinkles is visible. The map is a cell of a texture that faces share, the atlas.
 *
 * After the page disposes of the material, the mesh is suspended: it frees its GPU resources, and is not updated until it is drawn again.
 */
export abstract class FramedMesh
  extends FaceGroup<AnyRenderer>
  implements FrameMember<AnyRenderer>, RaisedFace
{
  readonly mesh: Mesh
  readonly meshes: Mesh[] = []
  readonly place: MeshPlace
  readonly shaderInputs: ShaderInputs
  readonly material: PatchedMaterial
  readonly relief: LazyRelief
  readonly options: Required<WrinklesOptions>
  protected readonly renderer: RendererParts
  readonly #frame: RendererFrame
  #entry: FrameEntry<AnyRenderer>
  readonly #atlas: InfluenceAtlas
  #cells: readonly Cell[]
  /** Whether the page has disposed of the material, and not drawn the mesh again. */
  #isSuspended = false
  #appearance: Appearance | null = null

  constructor({ renderer, mesh, material, options, areas, array, textures }: FramedMeshParts) {
    super(countFaces(mesh), areas, array)
    this.mesh = mesh
    this.renderer = renderer
    this.options = options
    this.#frame = frameOf(renderer.quads)
    this.#atlas = this.#frame.atlasFor(array.width, array.height, textures.layers.length)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    this.shaderInputs = createShaderInputs(textures, array, this.#atlas, instancesOf(mesh) !== null)
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
  }

  get mode(): WrinkleMode {
    return this.material.mode
  }

  /** @throws FurrowError if the mode is unsupported for the mesh or material; the mode then stays unchanged. */
  set mode(mode: WrinkleMode) {
    this.checkInUse('mode')
    checkMode(mode)
    if (mode === this.mode) return
    this.material.show(mode)
    this.relief.resume()
  }

  /** Updates inputs, drivers and activations. Influence maps are drawn only if a renderer is given. */
  update(renderer: AnyRenderer | null): void {
    this.checkInUse('update')
    if (renderer !== null && typeof renderer?.render !== 'function') {
      throw wrongArgument('Wrinkles.update', 'renderer', renderer, 'a renderer of three.js, or null')
    }
    if (renderer) {
      checkRenderer(renderer, this.renderer.entry, 'Wrinkles')
      this.resume()
    }
    this.#frame.update(this.#entry, renderer)
  }

  /** Fades the wrinkles in over the next frames. */
  appear(appearance: Appearance): void {
    this.#appearance = appearance
  }

  /** Updates the material when another face joins the frame: the current shader of the material may require an atlas with a single face. */
  refresh(): void {
    this.material.settle(null)
  }

  prepareIn(scene: Scene, renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    this.#entry.isLate ||= isPrepared(mesh)
    if (!this.prepare(renderer, camera, mesh, Boolean(scene.overrideMaterial))) return
    this.#frame.trackScene(scene, this.#entry, renderer)
  }

  /**
   * Called before a mesh is drawn. Updates the material, runs all phases of the frame (see `Frame`), and sets the uniforms of the shader.
   *
   * @param isOverridden whether an override material draws the mesh, e.g. for shadows. The opacity then stays unchanged.
   * @returns whether the phases ran.
   */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh, isOverridden = false): boolean {
    if (this.isDisposed || this.renderer.isCompiling?.(renderer)) return false
    if (isRefused(renderer, this.renderer.entry, 'Wrinkles')) {
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
    // Comes after the drivers, because the relief mode `near` depends on activations.
    this.relief.prepare(renderer, camera, mesh)
    return true
  }

  /** Phase 4 of a frame: reports changed influence maps to the atlas, see `FrameMember`. */
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

  /** Phase 5: updates the normal map of mode `composed`, or the activation table of mode `paper`. */
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

  /** Frees all GPU resources until a mesh is drawn again. */
  #suspend(): void {
    if (this.#isSuspended) return
    this.#isSuspended = true
    this.relief.suspend()
    this.material.suspend()
    this.#leave()
    this.release()
  }

  /**
   * Resumes after the current frame, because a new cell may resize the atlas, which the current frame reads. Separate method, because a
   * closure in `prepare` would allocate in every frame.
   */
  #resumeLater(): void {
    queueMicrotask(() => this.resume())
  }

  /** Undoes `#suspend`. Must not be called during a frame. */
  protected resume(): void {
    if (this.isDisposed || !this.#isSuspended) return
    this.#isSuspended = false
    this.#frame.restore(this.#atlas)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    retainShaderInputs(this.shaderInputs)
    this.material.resume()
  }

  /** Removes the mesh from the frame loop, and frees resources that no other face uses. */
  #leave(): void {
    this.#frame.remove(this.#entry)
    this.#atlas.remove(this.#cells)
    this.#frame.release(this.#atlas)
    releaseShaderInputs(this.shaderInputs)
  }

  /** Opacity of the wrinkles, 0..1, from the fade-in and the size of the mesh on screen. */
  #fadeOf(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
    const appeared = this.#appearance?.advance(this.clock) ?? 1
    const { fadeBelow } = this.options
    if (fadeBelow === 0 || this.mode === 'composed' || instancesOf(this.mesh)) return appeared
    return appeared * fadeOnScreen(mesh, camera, renderer, fadeBelow)
  }

  protected rebind(array: AreaArray, areas: readonly Area<ArraySlice>[]): void {
    this.#atlas.rebind(this.#cells, array, areas)
  }
}
