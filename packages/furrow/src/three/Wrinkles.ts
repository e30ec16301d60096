import type { DataArrayTexture, Material, Mesh, MeshStandardMaterial, Texture } from 'three'
import { SRGBColorSpace } from 'three'
import { Activations, type Slot } from '../core/activations.ts'
import { combineNormals } from '../core/combine-normals.ts'
import { FurrowError } from '../core/error.ts'
import { DEFAULT_AREA_SIZE } from '../core/limits.ts'
import { packAreas, packColours } from '../core/pack.ts'
import { scaleNormals } from '../core/scale-normals.ts'
import type { Area, Layer, LayerKind, RgbaImage, WrinkleSet } from '../core/types.ts'
import { checkArea, checkWrinkleSet, layerIndex } from '../core/wrinkle-set.ts'
import { checkMaterial, checkMesh } from './check-mesh.ts'
import { readTexture } from './read-texture.ts'
import { activationTexture, areaTexture, colourTexture, flatNormalTexture } from './textures.ts'

/** `default` mixes normals and lights once; `paper` lights twice and mixes colours; `off` shows none. */
export type WrinkleMode = 'default' | 'paper' | 'off'

export interface WrinklesOptions {
  /** `default` unless told. */
  mode?: WrinkleMode
  /** Side of the common grid of the areas in texels, 128 unless told. */
  areaSize?: number
}

export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = { mode: 'default', areaSize: DEFAULT_AREA_SIZE }

/** A material with normals to wrinkle: standard, physical, Phong, Lambert, Toon or MatCap. */
export type WrinkleMaterial = Material &
  Pick<MeshStandardMaterial, 'normalMap' | 'normalMapType' | 'normalScale'>

/** What a shader reads; the objects stay the same as long as the wrinkles live. */
export interface WrinkleInputs {
  /** One layer per area, one channel; its depth changes when areas come and go. */
  areas: DataArrayTexture
  /** Wrinkled normals, one per layer of the set. */
  normals: DataArrayTexture
  /** The paper's array: diffuse, smooth normals, wrinkled normals. In paper mode only. */
  colours: DataArrayTexture | null
  /** Whether the diffuse texture in `colours` is encoded in sRGB, as the material's own map says. */
  diffuseIsSrgb: boolean
  /** See `Activations.table`. */
  activations: Texture
  /** How many areas there are. */
  areaCount: { value: number }
  /** How each layer of `normals` is laid on. */
  kinds: readonly LayerKind[]
}

/** What a renderer's class adds. */
export interface RendererParts {
  /** Makes a material show wrinkles, and returns what takes that back; `needsUpdate` is set by the caller. */
  patch(material: WrinkleMaterial, inputs: WrinkleInputs, mode: Exclude<WrinkleMode, 'off'>): () => void
  /** A material that shows the influence as gray. */
  influenceMaterial(inputs: WrinkleInputs): Material
}

const owners = new WeakMap<Material, WrinklesBase>()

/**
 * Wrinkles on one mesh; each renderer's class adds its way to patch. The material stays the user's own: morphs, skinning, shadows,
 * environment and `normalScale` keep working, and `dispose` gives it back as it was.
 */
export abstract class WrinklesBase {
  readonly mesh: Mesh
  /** Whether the drivers of the file move their areas; set it to false to move them yourself. */
  driven = true

  readonly #renderer: RendererParts
  readonly #material: WrinkleMaterial
  readonly #inputs: WrinkleInputs
  readonly #set: WrinkleSet
  readonly #areaSize: number
  readonly #activations: Activations
  readonly #flat: Texture | null
  #mode: WrinkleMode = 'off'
  #unpatch: () => void = () => {}
  readonly #disposers: (() => void)[] = []

  /**
   * @param renderer what the renderer's class adds.
   * @param mesh needs UVs and normals and a material of its own that is lit.
   * @param set copied; later changes to it are not seen, use `addArea` and `removeArea`.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
   */
  constructor(renderer: RendererParts, mesh: Mesh, set: WrinkleSet, options: WrinklesOptions = {}) {
    const { mode, areaSize } = { ...WRINKLES_DEFAULTS, ...options }
    checkWrinkleSet(set, 'Wrinkles')
    checkMesh(mesh)
    this.mesh = mesh
    this.#renderer = renderer
    this.#material = checkMaterial(mesh, (material) => owners.has(material))
    this.#set = { layers: [...set.layers], areas: [...set.areas] }
    this.#areaSize = areaSize
    const areas = areaTexture(packAreas(weightsOf(set.areas), areaSize, 'Wrinkles'))
    const normals = packColours(set.layers.map(normalsOf), 'Wrinkles layers')
    this.#activations = new Activations(slotsOf(this.#set), 'Wrinkles')
    for (const { name, activation } of set.areas) this.#activations.set(name, activation ?? 0)
    this.#inputs = {
      areas,
      normals: colourTexture(normals, this.#material.normalMap?.anisotropy ?? 1),
      colours: null,
      diffuseIsSrgb: false,
      activations: activationTexture(this.#activations),
      areaCount: { value: set.areas.length },
      kinds: set.layers.map(({ kind }) => kind),
    }
    this.#flat = this.#material.normalMap ? null : flatNormalTexture()
    if (this.#flat) this.#material.normalMap = this.#flat
    owners.set(this.#material, this)
    try {
      this.mode = mode
    } catch (error) {
      this.dispose()
      throw error
    }
  }

  /** Names of the areas, in the order they are packed. */
  get areaNames(): string[] {
    return this.#activations.slots.map(({ name }) => name)
  }

  get mode(): WrinkleMode {
    return this.#mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is compiled anew.
   *
   * @throws FurrowError when the paper's mode cannot be had: more than one layer, or maps of
   *   the material that cannot be read or differ in size; the mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    if (mode === this.#mode) return
    if (mode === 'paper' && !this.#inputs.colours) this.#inputs.colours = this.#packPaper()
    this.#unpatch()
    this.#unpatch = mode === 'off' ? () => {} : this.#renderer.patch(this.#material, this.#inputs, mode)
    this.#mode = mode
    this.#material.needsUpdate = true
  }

  /**
   * @param value 0..1; clamped with one warning.
   * @throws FurrowError when no area has that name.
   */
  setActivation(area: string, value: number): void {
    const before = this.#activations.version
    this.#activations.set(area, value)
    if (this.#activations.version !== before) this.#inputs.activations.needsUpdate = true
  }

  /** @throws FurrowError when no area has that name. */
  getActivation(area: string): number {
    return this.#activations.get(area)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return this.#activations.has(name)
  }

  /**
   * Adds an area while the program runs, with its activation at rest. The shader program stays.
   *
   * @throws FurrowError when its name is taken, its image malformed or its layer unknown; nothing changes then.
   */
  addArea(area: Area): void {
    checkArea(area, this.#set.layers, 'Wrinkles.addArea')
    this.#replaceAreas([...this.#set.areas, area], 'Wrinkles.addArea')
    this.#activations.set(area.name, area.activation ?? 0)
  }

  /**
   * Removes an area while the program runs. The shader program stays.
   *
   * @throws FurrowError when no area has that name, or it is the last one.
   */
  removeArea(name: string): void {
    this.#activations.get(name)
    this.#replaceAreas(
      this.#set.areas.filter((area) => area.name !== name),
      'Wrinkles.removeArea',
    )
  }

  /**
   * A material that shows where wrinkles are, as gray on the moving mesh: how much of them now, or the extent of
   * one area whatever its activation. Made for looking; dispose it when done, and make it anew after areas
   * came or went.
   *
   * @throws FurrowError when no area has that name.
   */
  createInfluenceMaterial(area?: string): Material {
    if (area === undefined) return this.#renderer.influenceMaterial(this.#inputs)
    const single = new Activations(this.#activations.slots, 'Wrinkles.createInfluenceMaterial')
    single.set(area, 1)
    const activations = activationTexture(single)
    const material = this.#renderer.influenceMaterial({ ...this.#inputs, activations })
    material.addEventListener('dispose', () => activations.dispose())
    return material
  }

  /** Has something done when these wrinkles are disposed of. */
  onDispose(dispose: () => void): void {
    this.#disposers.push(dispose)
  }

  /** Gives the material back as it was and frees the textures. */
  dispose(): void {
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.mode = 'off'
    if (this.#flat) {
      this.#material.normalMap = null
      this.#flat.dispose()
    }
    for (const texture of [
      this.#inputs.areas,
      this.#inputs.normals,
      this.#inputs.colours,
      this.#inputs.activations,
    ]) {
      texture?.dispose()
    }
    owners.delete(this.#material)
    // Renderers keep a program's inputs with the material; wrinkles put on it later must bring their own.
    this.#material.dispose()
  }

  #replaceAreas(areas: Area[], who: string): void {
    checkWrinkleSet({ layers: this.#set.layers, areas }, who)
    const packed = packAreas(weightsOf(areas), this.#areaSize, who)
    this.#set.areas = areas
    this.#activations.rebind(slotsOf(this.#set))
    // The texture object stays, since shaders hold it; only its storage is made anew at the new depth.
    this.#inputs.areas.dispose()
    this.#inputs.areas.image = { ...packed }
    this.#inputs.areas.needsUpdate = true
    this.#inputs.activations.needsUpdate = true
    this.#inputs.areaCount.value = areas.length
  }

  #packPaper(): DataArrayTexture {
    const { layers } = this.#set
    if (layers.length !== 1) {
      throw new FurrowError({
        who: 'Wrinkles.mode',
        what: 'the paper knows one wrinkled normal map',
        value: layers.map(({ name }) => name).join(', '),
        limit: 'one layer',
        remedy: 'use the default mode',
      })
    }
    const normals = normalsOf(layers[0])
    const { map } = this.#material as Partial<MeshStandardMaterial>
    this.#inputs.diffuseIsSrgb = map?.colorSpace === SRGBColorSpace
    const diffuse = map ? readTexture(map, 'Wrinkles.mode') : filled(normals, [255, 255, 255, 255])
    const smooth =
      this.#flat || !this.#material.normalMap
        ? filled(normals, [128, 128, 255, 255])
        : readTexture(this.#material.normalMap, 'Wrinkles.mode')
    const wrinkled = layers[0].kind === 'detail' ? combineNormals(smooth, normals) : normals
    return colourTexture(
      packColours([diffuse, smooth, wrinkled], 'Wrinkles.mode paper'),
      this.#inputs.normals.anisotropy,
    )
  }
}

function normalsOf({ normal, normalScale }: Layer): RgbaImage {
  return scaleNormals(normal, normalScale ?? 1)
}

function weightsOf(areas: readonly Area[]) {
  return areas.map(({ weights }) => weights)
}

function slotsOf({ layers, areas }: WrinkleSet): Slot[] {
  return areas.map((area) => ({
    name: area.name,
    layer: layerIndex(area, layers),
    combine: area.combine ?? 'sum',
  }))
}

function filled({ width, height }: RgbaImage, texel: number[]): RgbaImage {
  const data = new Uint8Array(width * height * 4)
  for (let i = 0; i < data.length; i++) data[i] = texel[i % 4]
  return { width, height, data }
}
