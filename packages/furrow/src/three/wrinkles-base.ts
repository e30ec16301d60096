import type { Camera, Material, Mesh } from 'three'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkArea, checkWrinkleSet } from '../core/wrinkle-set.ts'
import { createAreaArray } from './atlas/area-array.ts'
import { releaseAtlas, sharedAtlas } from './atlas/atlases.ts'
import type { AnyRenderer, Cell, InfluenceAtlas } from './atlas/influence-atlas.ts'
import { checkMesh } from './check-mesh.ts'
import { DrivenFaces } from './driven-faces.ts'
import { instancesOf } from './instances.ts'
import { exposeAreas } from './loader/key-frames.ts'
import { ActivationTable } from './material/activation-table.ts'
import { freeMaterial, WornMaterial } from './material/patched-material.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import { createInputs, placeCells, type WrinkleInputs } from './material/shader-inputs.ts'
import { release, retain } from './material/texture-users.ts'
import { createTextures, listTextures } from './material/wrinkle-textures.ts'
import { WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
import { sizeOnScreen } from './size-on-screen.ts'

const wearers = new WeakMap<Mesh, WrinklesBase>()

/** The wrinkles on a mesh, however they came there; of several, those put on first. */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined {
  return wearers.get(mesh)
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`; each renderer's class adds its way to patch. The
 * material stays the user's own: morphs, skinning, shadows, environment and `normalScale` keep working, and
 * `dispose` gives it back as it was.
 */
export abstract class WrinklesBase extends DrivenFaces {
  readonly #options: Required<WrinklesOptions>
  readonly #atlas: InfluenceAtlas
  readonly #cells: readonly Cell[]
  readonly #inputs: WrinkleInputs
  readonly #worn: WornMaterial
  /** Version of the activations that the table holds. */
  #written = -1
  /** Influence materials alive: they want the map drawn whatever the mode. */
  #watchers = 0

  /**
   * @param renderer what the renderer's class adds.
   * @param mesh needs UVs and normals and a material of its own that is lit.
   * @param source a set, copied: later changes to it are not seen, use `addArea` and `removeArea`. Or the wrinkles
   *   of another mesh, which are then shown here too, at rest, from the same textures.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
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
    const full = { ...WRINKLES_DEFAULTS, ...own, ...options }
    checkWrinkleSet(set, 'Wrinkles')
    checkMesh(mesh)
    const material = freeMaterial(mesh)
    const areas = inputs?.areas ?? createAreaArray(set.areas, set.layers, full.areaSize, 'Wrinkles')
    const textures = inputs?.textures ?? createTextures(set.layers, material.normalMap?.anisotropy ?? 1)
    super(mesh, set.areas, areas)
    this.#options = full
    this.#atlas = sharedAtlas(renderer.quads, areas.width, areas.height, set.layers.length)
    this.#cells = this.#atlas.add(this.faces)
    this.#inputs = createInputs(textures, areas, this.#atlas)
    for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
    this.#worn = new WornMaterial(mesh, material, this.#inputs, renderer)
    this.addMesh(mesh)
    try {
      this.mode = full.mode
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  get mode(): WrinkleMode {
    return this.#worn.mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is compiled anew. The composed mode shows the layers' normals
   * alone, and does not fade.
   *
   * @throws FurrowError when the paper's mode cannot be had: more than one layer, or maps of
   *   the material that cannot be read or differ in size; or the composed one, for instances. The mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    if (mode !== this.mode) this.#worn.show(mode)
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
   * A material that shows where wrinkles are, as gray on the moving mesh: how much of them now, or the extent of
   * one area, or several, whatever their activations. Made for looking; dispose it when done, and make it anew after areas
   * came or went.
   *
   * @throws FurrowError when no area has that name.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    const table = area === undefined ? null : this.#extentOf([area].flat())
    const material = this.#worn.influenceMaterial(table)
    if (!table) this.#watchers++
    material.addEventListener('dispose', () => {
      if (table) table.texture.dispose()
      else this.#watchers--
    })
    return material
  }

  /**
   * Tells of another mesh that wears the material, such as a second primitive of the face: it shows the same
   * wrinkles, whichever of them is drawn first.
   */
  addMesh(mesh: Mesh): void {
    const before = mesh.onBeforeRender
    // All named: a list of the rest would be allocated in every frame.
    const prepare: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, material, group) => {
      before.call(mesh, renderer, scene, camera, geometry, material, group)
      this.#prepare(renderer as AnyRenderer, camera, mesh)
    }
    mesh.onBeforeRender = prepare
    if (!wearers.has(mesh)) wearers.set(mesh, this)
    if (mesh === this.mesh) exposeAreas(mesh, this)
    this.onDispose(() => {
      if (mesh.onBeforeRender === prepare) mesh.onBeforeRender = before
      if (wearers.get(mesh) === this) wearers.delete(mesh)
    })
  }

  /** A copy of the material as it is without wrinkles, for a mesh that shall have some of its own. */
  cloneMaterial(): Material {
    return this.#worn.clone()
  }

  /** Gives the material back as it was and frees the textures that no other face shares. */
  override dispose(): void {
    super.dispose()
    this.#worn.dispose()
    this.#atlas.remove(this.#cells)
    releaseAtlas(this.#atlas)
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

  #prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    const { fade, areas, paper } = this.#inputs
    const { mode, composed } = this.#worn
    const { fadeBelow } = this.#options
    const isFull = composed || fadeBelow === 0 || instancesOf(this.mesh)
    const share = isFull ? 1 : (2 * sizeOnScreen(mesh, camera, renderer)) / fadeBelow - 1
    fade.value = Math.min(1, Math.max(0, share))
    if (fade.value > 0 && (mode === 'default' || composed || this.#watchers > 0)) {
      this.#atlas.update(this.#cells, renderer)
      placeCells(this.#inputs, this.#atlas, this.#cells)
      composed?.update(renderer, areas, this.faces[0].values)
    } else {
      this.faces[0].drive(renderer)
    }
    const { activations } = this.faces[0]
    if (mode !== 'paper' || activations.version === this.#written) return
    this.#written = activations.version
    paper!.table.write(areas, activations.values)
  }

  #replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    const { textures, areas: old } = this.#inputs
    checkWrinkleSet({ layers: textures.layers, areas }, who)
    const array = createAreaArray(areas, textures.layers, this.#options.areaSize, who)
    retain(array.texture)
    release(old.texture)
    this.#inputs.areas = array
    this.#inputs.areaTexture.value = array.texture
    this.#written = -1
    this.areas = areas
    for (const [i, face] of this.faces.entries()) {
      face.rebind(array, areas)
      this.#cells[i].stale = true
    }
    this.#atlas.prune()
    exposeAreas(this.mesh, this)
    // The paper's nodes hold the array itself.
    if (this.mode === 'paper') this.#worn.show('paper')
  }
}
