import type { Camera, Material, Mesh, Texture } from 'three'
import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkArea, checkWrinkleSet } from '../core/wrinkle-set.ts'
import { AGES } from '../drivers/age.ts'
import type { Expression } from '../drivers/expression.ts'
import { ActivationTable } from './activation-table.ts'
import { createAreaArray } from './area-array.ts'
import { releaseAtlas, sharedAtlas } from './atlases.ts'
import { checkMaterial, checkMesh, checkNotInstanced } from './check-mesh.ts'
import { ComposedMap } from './composed-map.ts'
import { Face } from './face.ts'
import type { AnyRenderer, Cell, InfluenceAtlas } from './influence-atlas.ts'
import { createInputs, placeCells, type WrinkleInputs } from './inputs.ts'
import { countFaces, instancesOf } from './instances.ts'
import { exposeAreas } from './key-frames.ts'
import { WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
import { packPaperArray } from './paper-array.ts'
import type { RendererParts, WrinkleMaterial } from './renderer-parts.ts'
import { release, retain } from './shared.ts'
import { sizeOnScreen } from './size-on-screen.ts'
import { flatNormalTexture } from './textures.ts'
import { createTextures, listTextures } from './wrinkle-textures.ts'

const owners = new WeakMap<Material, WrinklesBase>()
const wearers = new WeakMap<Mesh, WrinklesBase>()

/** Brings one face's activations up to date. */
type Drive = (face: Face, instance: number, renderer: AnyRenderer) => void

/** The wrinkles on a mesh, however they came there; of several, those put on first. */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined {
  return wearers.get(mesh)
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`; each renderer's class adds its way to patch. The
 * material stays the user's own: morphs, skinning, shadows, environment and `normalScale` keep working, and
 * `dispose` gives it back as it was.
 */
export abstract class WrinklesBase {
  readonly mesh: Mesh
  /** Whether the drivers of the file move their areas; set it to false to move them yourself. */
  driven = true
  /** Presets that the file brings. */
  expressions: readonly Expression[] = []
  /** Tells milliseconds to drivers that take their time; replace it where frames are not drawn as time passes. */
  clock: { now(): number } = performance

  readonly #renderer: RendererParts
  readonly #options: Required<WrinklesOptions>
  readonly #material: WrinkleMaterial
  readonly #flat: Texture | null
  readonly #atlas: InfluenceAtlas
  readonly #faces: readonly Face[]
  readonly #cells: readonly Cell[]
  readonly #inputs: WrinkleInputs
  #areas: Area<ArraySlice>[]
  #age: number = AGES.youngest
  #mode: WrinkleMode = 'off'
  #unpatch: () => void = () => {}
  #composed: ComposedMap | null = null
  /** Version of the activations that the table holds. */
  #written = -1
  /** Influence materials alive: they want the map drawn whatever the mode. */
  #watchers = 0
  readonly #drivers: Drive[] = []
  /** Areas that drivers set in every frame, whatever they were set to. */
  #driven: ReadonlySet<string> = new Set()
  readonly #disposers: (() => void)[] = []

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
    const shared = source instanceof WrinklesBase ? source.#shared() : null
    this.#options = { ...WRINKLES_DEFAULTS, ...shared?.options, ...options }
    const set = shared?.set ?? (source as WrinkleSet<ArraySlice>)
    checkWrinkleSet(set, 'Wrinkles')
    checkMesh(mesh)
    this.mesh = mesh
    this.#renderer = renderer
    this.#material = checkMaterial(mesh, (material) => owners.has(material))
    const areas =
      shared?.inputs.areas ?? createAreaArray(set.areas, set.layers, this.#options.areaSize, 'Wrinkles')
    const textures =
      shared?.inputs.textures ?? createTextures(set.layers, this.#material.normalMap?.anisotropy ?? 1)
    this.#areas = [...set.areas]
    this.#atlas = sharedAtlas(renderer.quads, areas.width, areas.height, set.layers.length)
    this.#faces = Array.from(
      { length: countFaces(mesh) },
      (_, instance) =>
        new Face(areas, this.#areas, (face, renderer) => this.#drive(face, instance, renderer)),
    )
    this.#cells = this.#atlas.add(this.#faces)
    this.#inputs = createInputs(textures, areas, this.#atlas)
    for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
    this.#flat = this.#material.normalMap ? null : flatNormalTexture()
    if (this.#flat) this.#material.normalMap = this.#flat
    owners.set(this.#material, this)
    this.addMesh(mesh)
    try {
      this.mode = this.#options.mode
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  /** Names of the areas, in the order they are packed. */
  get areaNames(): string[] {
    return this.#areas.map(({ name }) => name)
  }

  get mode(): WrinkleMode {
    return this.#mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is compiled anew. The composed mode shows the layers' normals
   * alone, and does not fade.
   *
   * @throws FurrowError when the paper's mode cannot be had: more than one layer, or maps of
   *   the material that cannot be read or differ in size; or the composed one, for instances. The mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    if (mode === this.#mode) return
    if (mode === 'paper') {
      const smooth = this.#flat ? null : this.#material.normalMap
      this.#inputs.paper ??= {
        ...packPaperArray(this.#inputs.textures.layers, this.#material, smooth),
        table: new ActivationTable(),
      }
    }
    if (mode === 'composed') checkNotInstanced(this.mesh)
    this.#patch(mode)
    this.#mode = mode
  }

  /**
   * @param value 0..1; clamped with one warning.
   * @param instance of an `InstancedMesh` or `BatchedMesh`; 0 unless told.
   * @throws FurrowError when no area has that name.
   */
  setActivation(area: string, value: number, instance = 0): void {
    const face = this.#faces[instance]
    // What nothing else moves stays as it is set; age adds to it, and delays follow it.
    if (this.#driven.has(area)) face.activations.set(area, value)
    else face.rest(area, value)
  }

  /**
   * The same for many at once; names that no area has are passed over, and nothing is allocated.
   *
   * @param values 0..1, in the order of the names.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    const { activations, resting } = this.#faces[instance]
    activations.takeNamed(names, values)
    resting.takeNamed(names, values, this.#driven)
  }

  /** @throws FurrowError when no area has that name. */
  getActivation(area: string, instance = 0): number {
    return this.#faces[instance].activations.get(area)
  }

  /**
   * Changes an area's activation at rest, to which drivers add: key frames of a file do, and so may you.
   *
   * @param value 0..1; clamped with one warning.
   * @throws FurrowError when no area has that name.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    this.#faces[instance].rest(area, value)
  }

  /** @throws FurrowError when no area has that name. */
  getRestingActivation(area: string, instance = 0): number {
    return this.#faces[instance].resting.get(area)
  }

  /** The person's age in years, for areas with drivers of type `age`; 20 unless told. */
  get age(): number {
    return this.#age
  }

  /** @throws FurrowError when it is no number. */
  set age(years: number) {
    if (!Number.isFinite(years)) {
      throw new FurrowError({
        who: 'Wrinkles.age',
        what: 'no age',
        value: years,
        limit: 'a number of years; faces change from 20 to 80',
        remedy: 'give one',
      })
    }
    this.#age = years
  }

  /** One of the areas as it was given. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return this.#areas.find((area) => area.name === name)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return this.#faces[0].activations.has(name)
  }

  /**
   * Adds an area while the program runs, with its activation at rest. The shader program stays.
   *
   * @throws FurrowError when its name is taken, its image malformed or its layer unknown; nothing changes then.
   */
  addArea(area: Area): void {
    checkArea(area, this.#inputs.textures.layers, 'Wrinkles.addArea')
    this.#replaceAreas([...this.#areas, area], 'Wrinkles.addArea')
    for (const face of this.#faces) face.rest(area.name, area.activation ?? 0)
  }

  /**
   * Removes an area while the program runs. The shader program stays.
   *
   * @throws FurrowError when no area has that name, or it is the last one.
   */
  removeArea(name: string): void {
    this.getActivation(name)
    this.#replaceAreas(
      this.#areas.filter((area) => area.name !== name),
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
    if (area === undefined) {
      this.#watchers++
      const material = this.#influenceMaterial(null)
      material.addEventListener('dispose', () => this.#watchers--)
      return material
    }
    const chosen = typeof area === 'string' ? [area] : area
    for (const name of chosen) this.getActivation(name)
    const table = new ActivationTable()
    table.write(
      this.#inputs.areas,
      Float32Array.from(this.#areas, ({ name }) => (chosen.includes(name) ? 1 : 0)),
    )
    const material = this.#influenceMaterial(table)
    material.addEventListener('dispose', () => table.texture.dispose())
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
    this.#unpatch()
    const { normalMap } = this.#material
    if (this.#flat) this.#material.normalMap = null
    const copy = this.#material.clone()
    this.#material.normalMap = normalMap
    this.#unpatch = this.#patched(this.#mode)
    return copy
  }

  /**
   * Has something done each time before a face is drawn, while `driven` is true.
   *
   * @param areas that it sets, whatever they were set to.
   */
  onDrive(drive: Drive, areas: readonly string[]): void {
    this.#drivers.push(drive)
    this.#driven = new Set([...this.#driven, ...areas])
  }

  /** Whether blendshapes, joints or the like move an area, so that `setActivation` lasts until the next frame only. */
  isDriven(area: string): boolean {
    return this.driven && this.#driven.has(area)
  }

  /** Has something done when these wrinkles are disposed of. */
  onDispose(dispose: () => void): void {
    this.#disposers.push(dispose)
  }

  /** Gives the material back as it was and frees the textures that no other face shares. */
  dispose(): void {
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.#drivers.length = 0
    this.mode = 'off'
    if (this.#flat) {
      this.#material.normalMap = null
      this.#flat.dispose()
    }
    this.#atlas.remove(this.#cells)
    releaseAtlas(this.#atlas)
    const { textures, areas, paper } = this.#inputs
    for (const texture of [areas.texture, ...listTextures(textures)]) release(texture)
    paper?.texture.dispose()
    paper?.table.texture.dispose()
    owners.delete(this.#material)
    // Renderers keep a program's inputs with the material; wrinkles put on it later must bring their own.
    this.#material.dispose()
  }

  #influenceMaterial(table: ActivationTable | null): Material {
    return this.#renderer.influenceMaterial(this.#material, this.#inputs, table, instancesOf(this.mesh))
  }

  /** What other meshes may show too. */
  #shared() {
    const set = { layers: [...this.#inputs.textures.layers], areas: this.#areas }
    return { set, inputs: this.#inputs, options: this.#options }
  }

  #patch(mode: WrinkleMode): void {
    this.#unpatch()
    this.#unpatch = this.#patched(mode)
    this.#material.needsUpdate = true
  }

  #patched(mode: WrinkleMode): () => void {
    if (mode === 'off') return () => {}
    if (mode === 'composed') return this.#compose()
    return this.#renderer.patch(this.#material, this.#inputs, mode, instancesOf(this.mesh))
  }

  /** Puts the composed map in the place of the material's own. */
  #compose(): () => void {
    const { composeMaterial, quads } = this.#renderer
    const base = this.#material.normalMap!
    const normals = this.#inputs.textures.normals.texture
    const composed = new ComposedMap(base, normals, composeMaterial(base, this.#inputs), quads.survives)
    this.#composed = composed
    this.#material.normalMap = composed.target.texture
    return () => {
      this.#material.normalMap = base
      this.#composed = null
      composed.dispose()
    }
  }

  #drive(face: Face, instance: number, renderer: AnyRenderer): void {
    if (this.driven) for (const drive of this.#drivers) drive(face, instance, renderer)
  }

  #prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    const { fade, areas, paper } = this.#inputs
    fade.value = this.#composed ? 1 : this.#fadeOf(renderer, camera, mesh)
    if (fade.value > 0 && (this.#mode === 'default' || this.#composed || this.#watchers > 0)) {
      this.#atlas.update(this.#cells, renderer)
      placeCells(this.#inputs, this.#atlas, this.#cells)
      this.#composed?.update(renderer, areas, this.#faces[0].values)
    } else {
      this.#faces[0].drive(renderer)
    }
    const { activations } = this.#faces[0]
    if (this.#mode !== 'paper' || activations.version === this.#written) return
    this.#written = activations.version
    paper!.table.write(areas, activations.values)
  }

  #fadeOf(renderer: AnyRenderer, camera: Camera, mesh: Mesh): number {
    const { fadeBelow } = this.#options
    if (fadeBelow === 0 || instancesOf(this.mesh)) return 1
    return Math.min(1, Math.max(0, (2 * sizeOnScreen(mesh, camera, renderer)) / fadeBelow - 1))
  }

  #replaceAreas(areas: Area<ArraySlice>[], who: string): void {
    const { textures, areas: old } = this.#inputs
    checkWrinkleSet({ layers: [...textures.layers], areas }, who)
    const array = createAreaArray(areas, textures.layers, this.#options.areaSize, who)
    retain(array.texture)
    release(old.texture)
    this.#inputs.areas = array
    this.#inputs.areaTexture.value = array.texture
    this.#written = -1
    this.#areas = areas
    for (const [i, face] of this.#faces.entries()) {
      face.rebind(array, areas)
      this.#cells[i].stale = true
    }
    this.#atlas.prune()
    exposeAreas(this.mesh, this)
    // The paper's nodes hold the array itself.
    if (this.#mode === 'paper') this.#patch('paper')
  }
}
