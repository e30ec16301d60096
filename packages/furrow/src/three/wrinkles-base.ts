import type { Camera, Material, Mesh } from 'three'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkArea, checkWrinkleSet } from '../core/wrinkle-set.ts'
import type { Cell } from '../runtime/atlas-cells.ts'
import type { FrameEntry, FrameMember } from '../runtime/frame.ts'
import { WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import { exposeAreas } from './animated-areas.ts'
import { createAreaArray } from './atlas/area-array.ts'
import type { InfluenceAtlas } from './atlas/influence-atlas.ts'
import { checkMesh } from './check-mesh.ts'
import { frameOf, type RendererFrame } from './frame.ts'
import { countFaces, instancesOf } from './instances.ts'
import { ActivationTable } from './material/activation-table.ts'
import { checkMaterial, PatchedMaterial } from './material/patched-material.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import { createShaderInputs, placeCells, type ShaderInputs } from './material/shader-inputs.ts'
import { release, retain } from './material/texture-users.ts'
import { createTextures, listTextures } from './material/wrinkle-textures.ts'
import { WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
import type { AnyRenderer } from './renderer.ts'
import { sizeOnScreen } from './size-on-screen.ts'

const wrinklesByMesh = new WeakMap<Mesh, WrinklesBase>()

/** The wrinkles of a mesh, however they were added; of several, the first. */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined {
  return wrinklesByMesh.get(mesh)
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`; each renderer's class adds its way to patch. The
 * material stays the user's own: morphs, skinning, shadows, environment and `normalScale` keep working, and
 * `dispose` restores it.
 */
export abstract class WrinklesBase extends WrinkleFaces<AnyRenderer> implements FrameMember<AnyRenderer> {
  readonly mesh: Mesh
  readonly #options: Required<WrinklesOptions>
  readonly #frame: RendererFrame
  readonly #entry: FrameEntry<AnyRenderer>
  readonly #atlas: InfluenceAtlas
  readonly #cells: readonly Cell[]
  readonly #inputs: ShaderInputs
  readonly #material: PatchedMaterial
  /** Version of the activations that the paper's table holds. */
  #tableVersion = -1
  /** Influence materials in use: they show the map in any mode. */
  #influenceViews = 0

  /**
   * @param renderer what the renderer's class adds.
   * @param mesh needs UVs and normals and a lit material of its own.
   * @param source a set, copied: later changes to it are not seen, use `addArea` and `removeArea`. Or the wrinkles
   *   of another mesh, which are then shown here too, at rest, from the same textures.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(
    renderer: RendererParts,
    mesh: Mesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options: WrinklesOptions = {},
  ) {
    const [set, inputs, own] =
      source instanceof WrinklesBase
        ? [{ layers: source.#inputs.textures.layers, areas: source.areas }, source.#inputs, source.#options]
        : [source, null, null]
    const allOptions = { ...WRINKLES_DEFAULTS, ...own, ...options }
    checkWrinkleSet(set, 'Wrinkles')
    checkMesh(mesh)
    const material = checkMaterial(mesh)
    const areas = inputs?.areas ?? createAreaArray(set.areas, set.layers, allOptions.areaSize, 'Wrinkles')
    const textures = inputs?.textures ?? createTextures(set.layers, material.normalMap?.anisotropy ?? 1)
    super(countFaces(mesh), set.areas, areas)
    this.mesh = mesh
    this.#options = allOptions
    this.#frame = frameOf(renderer.quads)
    this.#atlas = this.#frame.atlasFor(areas.width, areas.height, set.layers.length)
    this.#cells = this.#atlas.add(this.faces)
    this.#entry = this.#frame.add(this)
    this.#inputs = createShaderInputs(textures, areas, this.#atlas)
    for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
    this.#material = new PatchedMaterial(mesh, material, this.#inputs, renderer)
    this.addMesh(mesh)
    try {
      this.mode = allOptions.mode
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  get mode(): WrinkleMode {
    return this.#material.mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is compiled again. The composed mode shows the layers' normals
   * alone, and does not fade.
   *
   * @throws FurrowError when the mode is not possible: `paper` with more than one layer, or with maps of the material that
   *   cannot be read or differ in size; `paper` and `composed` for instances. The mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    if (mode !== this.mode) this.#material.show(mode)
  }

  /** Number of instances, 1 for any other mesh. */
  get faceCount(): number {
    return this.faces.length
  }

  /**
   * Brings inputs, drivers and activations up to date now. Frames do so by themselves before they are drawn; this is for
   * tests, and for pages that read activations without drawing.
   *
   * @param renderer draws the influence maps too; without one, what only a renderer can measure keeps its last value.
   */
  update(renderer: AnyRenderer | null = null): void {
    this.#frame.update(this.#entry, renderer)
  }

  /**
   * Adds an area while the program runs, with its activation at rest. The shader program stays.
   *
   * @throws FurrowError when its name is taken, its image malformed or its layer unknown; nothing changes then.
   */
  addArea(area: Area): void {
    checkArea(area, this.#inputs.textures.layers, 'Wrinkles.addArea')
    this.#replaceAreas([...this.areas, area], 'Wrinkles.addArea')
    for (const face of this.faces) face.rest(area.name, area.activation ?? 0)
  }

  /**
   * Removes an area while the program runs. The shader program stays.
   *
   * @throws FurrowError when no area has that name, or it is the last one.
   */
  removeArea(name: string): void {
    this.getActivation(name)
    this.#replaceAreas(
      this.areas.filter((area) => area.name !== name),
      'Wrinkles.removeArea',
    )
  }

  /**
   * A material that shows the influence as gray on the moving mesh: the current one, or the extent of one area, or of
   * several, whatever their activations. Dispose it when done, and create it again after areas were added or removed.
   *
   * @throws FurrowError when no area has that name.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    const table = area === undefined ? null : this.#extentOf([area].flat())
    const material = this.#material.influenceMaterial(table)
    if (!table) this.#influenceViews++
    material.addEventListener('dispose', () => {
      if (table) table.texture.dispose()
      else this.#influenceViews--
    })
    return material
  }

  /**
   * Adds another mesh that has the material, such as a second primitive of the face: it shows the same wrinkles,
   * whichever of them is drawn first.
   */
  addMesh(mesh: Mesh): void {
    const before = mesh.onBeforeRender
    // All named: a rest parameter would allocate in every frame.
    const prepare: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, material, group) => {
      before.call(mesh, renderer, scene, camera, geometry, material, group)
      this.#prepare(renderer as AnyRenderer, camera, mesh)
    }
    mesh.onBeforeRender = prepare
    if (!wrinklesByMesh.has(mesh)) wrinklesByMesh.set(mesh, this)
    if (mesh === this.mesh) exposeAreas(mesh, this)
    this.onDispose(() => {
      if (mesh.onBeforeRender === prepare) mesh.onBeforeRender = before
      if (wrinklesByMesh.get(mesh) === this) wrinklesByMesh.delete(mesh)
    })
  }

  /** A copy of the material as it is without wrinkles, for another mesh with wrinkles of its own. */
  cloneMaterial(): Material {
    return this.#material.clone()
  }

  /** Phase 4 of a frame: influence maps, or the paper's table. */
  collectInfluence(renderer: AnyRenderer): boolean {
    const { fade, areas, paper } = this.#inputs
    const { mode, composed } = this.#material
    if (mode === 'paper') this.#writeTable(areas, paper!.table)
    const isShown = mode === 'default' || composed !== null || this.#influenceViews > 0
    if (fade.value === 0 || !isShown) return false
    this.#atlas.collect(this.#cells, renderer)
    return true
  }

  /** Phase 5: the composed normal map, in its mode. */
  composeNormals(renderer: AnyRenderer): void {
    const { composed } = this.#material
    if (!composed) return
    placeCells(this.#inputs, this.#atlas, this.#cells)
    composed.update(renderer, this.#inputs.areas, this.faces[0].activations.values)
  }

  /** Restores the material and frees the textures that no other face shares. */
  override dispose(): void {
    super.dispose()
    this.#frame.remove(this.#entry)
    this.#material.dispose()
    this.#atlas.remove(this.#cells)
    this.#frame.release(this.#atlas)
    const { textures, areas, paper } = this.#inputs
    for (const texture of [areas.texture, ...listTextures(textures)]) release(texture)
    paper?.texture.dispose()
    paper?.table.texture.dispose()
  }

  /** Some areas in full, and no others. */
  #extentOf(names: readonly string[]): ActivationTable {
    for (const name of names) this.getActivation(name)
    const table = new ActivationTable()
    table.write(
      this.#inputs.areas,
      Float32Array.from(this.areas, ({ name }) => Number(names.includes(name))),
    )
    return table
  }

  /** Before a mesh is drawn: the frame up to the influence, then what its shader reads. */
  #prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    this.#inputs.fade.value = this.#fadeOf(mesh, camera, renderer)
    this.#frame.begin(this.#entry, renderer)
    placeCells(this.#inputs, this.#atlas, this.#cells)
  }

  /** 1 = wrinkles in full, 0 = the mesh is too small on screen. */
  #fadeOf(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
    const { fadeBelow } = this.#options
    if (fadeBelow === 0 || this.#material.composed || instancesOf(this.mesh)) return 1
    return Math.min(1, Math.max(0, (2 * sizeOnScreen(mesh, camera, renderer)) / fadeBelow - 1))
  }

  #writeTable(areas: ShaderInputs['areas'], table: ActivationTable): void {
    const { version, values } = this.faces[0].activations
    if (version === this.#tableVersion) return
    this.#tableVersion = version
    table.write(areas, values)
  }

  #replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    const { textures, areas: old } = this.#inputs
    checkWrinkleSet({ layers: textures.layers, areas }, who)
    const array = createAreaArray(areas, textures.layers, this.#options.areaSize, who)
    retain(array.texture)
    release(old.texture)
    this.#inputs.areas = array
    this.#inputs.areaTexture.value = array.texture
    this.#tableVersion = -1
    this.areas = areas
    for (const [i, face] of this.faces.entries()) {
      face.rebind(array, areas)
      this.#cells[i].stale = true
    }
    this.#atlas.prune()
    exposeAreas(this.mesh, this)
    // The paper's nodes hold the array itself.
    if (this.mode === 'paper') this.#material.show('paper')
  }
}
