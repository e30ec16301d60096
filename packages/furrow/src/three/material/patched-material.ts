import { type Material, type Mesh, ObjectSpaceNormalMap, type Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import { checkNotInstanced } from '../mesh/check-mesh.ts'
import { instancesOf } from '../mesh/instances.ts'
import type { WrinkleMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { AutoMode } from './auto/auto-mode.ts'
import type { ComposedMap } from './composed-map.ts'
import { Fetched } from './fetched.ts'
import type { InfluenceView } from './other-modes.ts'
import type { Patch } from './patch.ts'
import type { PatchEvents, RendererParts } from './renderer-parts.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import { readsNormalMap, surfaceOf, withSurface } from './surface.ts'
import { flatNormalTexture } from './textures.ts'
import { cloneByClass, isToon, type WrinkleMaterial } from './wrinkle-material.ts'

const patchedMaterials = new WeakSet<Material>()

const autoMode = new Fetched(async () => (await import('./auto/auto-mode.ts')).AutoMode)

/**
 * The material of a mesh that shows its wrinkles.
 *
 * @throws FurrowError, which names the mesh, when it cannot, or shows others already.
 */
export function checkMaterial(mesh: Mesh): WrinkleMaterial {
  const material = surfaceOf(mesh) as WrinkleMaterial
  const problem = problemOf(material)
  if (!problem) return material
  throw new FurrowError({ who: 'Wrinkles', value: mesh.name, ...problem })
}

interface PatchedMaterialOptions extends Pick<PatchEvents, 'onCompile'> {
  /** See `WrinklesOptions`. */
  textureBudget: number
}

/** The user's own material while it shows wrinkles. */
export class PatchedMaterial {
  /** What is shown. */
  mode: WrinkleMode = 'off'
  /** Replaces the material's own normal map in the composed mode. */
  composed: ComposedMap | null = null
  readonly #mesh: Mesh
  readonly #material: WrinkleMaterial
  readonly #inputs: ShaderInputs
  readonly #renderer: RendererParts
  /** The normal map of a material that has none, while it shows wrinkles. */
  readonly #flat: Texture | null
  #unpatch: () => void = () => {}
  /** Makes the material draw relief too; null while there is none. */
  #patchRelief: ((material: Material) => () => void) | null = null
  /** Whether the shader turned out to be one that cannot be patched. */
  #isRefused = false
  /** The mode that is shown as soon as what it takes was fetched. */
  #pending: WrinkleMode | null = null
  #auto: AutoMode | null = null
  /** What makes the default mode of it, which `auto` leaves out now and then. */
  #patched: Patch | null = null
  /** Found before the material is patched. */
  #isComposable = false
  readonly #options: PatchedMaterialOptions

  constructor(
    mesh: Mesh,
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    renderer: RendererParts,
    options: PatchedMaterialOptions,
  ) {
    this.#options = options
    this.#mesh = mesh
    this.#material = material
    this.#inputs = inputs
    this.#renderer = renderer
    this.#flat = material.normalMap ? null : flatNormalTexture()
    // three.js writes the name into a line of the shader, which another line end, or a backslash before its own, would break.
    material.name &&= material.name.replace(/[\r\n\\]/g, ' ')
    patchedMaterials.add(material)
  }

  /** The mode that is shown, or is about to be. */
  get wanted(): WrinkleMode {
    return this.#pending ?? this.mode
  }

  /** What draws the composed map now and then in the mode `auto`; null where that never happens, or not yet. */
  get auto(): AutoMode | null {
    const others = this.#renderer.others.value
    if (this.mode !== 'auto' || !others || !autoMode.value || !this.#isComposable || !this.#patched)
      return null
    this.#auto ??= new autoMode.value({
      material: this.#material,
      inputs: this.#inputs,
      patch: this.#patched,
      // Relief edits it too.
      hasOwnProgram: this.#patchRelief === null,
      hasContents: this.#renderer.quads.hasContents,
      composeMaterial: others.composeMaterial,
      budget: this.#options.textureBudget,
    })
    return this.#auto
  }

  /**
   * Changes the mode, at once or when what it takes was fetched. A material that cannot be patched shows the composed mode instead of the
   * default one and `auto`.
   *
   * @throws FurrowError when the mode is not possible; it then stays as it was.
   */
  show(wanted: WrinkleMode): void {
    const { others } = this.#renderer
    const isPatched = wanted === 'default' || wanted === 'auto'
    const mode = isPatched && !this.#isPatchable ? 'composed' : wanted
    if (mode === 'paper' && !this.#isPatchable) {
      throw new FurrowError({
        code: 'unsupported',
        who: 'Wrinkles.mode',
        what: "the material's shader cannot be patched",
        value: mode,
        limit: 'composed or off',
        remedy: 'use the composed mode',
      })
    }
    if (mode === 'paper' || mode === 'composed') {
      checkNotInstanced(this.#mesh, mode)
      if (!others.value) {
        this.#showFetched(mode)
        return
      }
    }
    if (mode === 'paper') this.#packPaper()
    this.#pending = null
    this.#apply(mode)
    // Until then it is the default mode.
    if (mode !== 'auto' || !this.#isComposable) return
    Promise.all([others.load(), autoMode.load()]).catch(({ message }) => console.warn(message))
  }

  /**
   * Called before each frame, since only the first one tells what becomes of the shader: a material that could not be patched shows
   * the composed mode from the second on, and one whose shader the GPU refuses is plain again, with one warning.
   */
  settle(renderer: AnyRenderer): void {
    if (this.mode === 'off') return
    try {
      if (this.#isRefused && this.mode !== 'composed') this.show('default')
      if (this.mode === 'paper') this.#packPaper()
      this.#checkShader(renderer)
    } catch (error) {
      this.show('off')
      console.warn((error as Error).message)
    }
  }

  /** Makes the material draw relief too, in all modes but `off`; null for none. */
  setRelief(patch: ((material: Material) => () => void) | null): void {
    this.#patchRelief = patch
    if (this.mode !== 'off') this.#apply(this.mode)
  }

  /** Copies the material without wrinkles. */
  clone(): Material {
    this.#unpatch()
    const copy = cloneByClass(this.#material)
    this.#unpatch = this.#patch(this.mode)
    return copy
  }

  /** Copies what the mesh has as its material, without wrinkles; of several materials only the one that shows them. */
  cloneAll(): Material | Material[] {
    return withSurface(this.#mesh, this.#material, this.clone())
  }

  /** Creates a material that shows influence as gray: black until what draws it was fetched. */
  influenceMaterial(weights?: InfluenceView['weights']): Material {
    const { others, unlitMaterial } = this.#renderer
    const material = unlitMaterial()
    const wrinkled = this.#flat ? { normalMap: this.#flat } : this.#material
    const view = { wrinkled, inputs: this.#inputs, instances: instancesOf(this.#mesh), weights }
    if (others.value) others.value.showInfluence(material, view)
    else {
      const showFetched = async () => (await others.load()).showInfluence(material, view)
      showFetched().catch(({ message }) => console.warn(message))
    }
    return material
  }

  /** Restores the material. */
  dispose(): void {
    this.show('off')
    this.#flat?.dispose()
    patchedMaterials.delete(this.#material)
    // Renderers cache uniforms with the material; wrinkles added later need their own.
    this.#material.dispose()
  }

  /** The user's own. */
  get material(): Material {
    return this.#material
  }

  get #isPatchable(): boolean {
    return !this.#isRefused && this.#renderer.canPatch(this.#material)
  }

  /** Whether a composed map would look as the default mode does: it has normals only, of one face, which the material's own program reads. */
  get #canCompose(): boolean {
    const { fragmentShader, normalNode } = this.#material as WrinkleMaterial & { normalNode?: unknown }
    const hasNormalsOnly = Object.keys(this.#inputs.textures.values).length === 0
    const isRead = fragmentShader === undefined && !normalNode
    return hasNormalsOnly && isRead && !isToon(this.#material) && !instancesOf(this.#mesh)
  }

  #apply(mode: WrinkleMode): void {
    this.#unpatch()
    this.#unpatch = this.#patch(mode)
    this.#renderer.renew(this.#material)
    this.mode = mode
  }

  /** Until then what is shown stays. */
  async #showFetched(mode: WrinkleMode): Promise<void> {
    if (this.#pending === mode) return
    this.#pending = mode
    try {
      await this.#renderer.others.load()
      if (this.#pending === mode) this.show(mode)
    } catch (error) {
      this.#pending = null
      // A shader that cannot be patched would ask for it again in every frame.
      if (this.#isRefused) this.show('off')
      console.warn((error as Error).message)
    }
  }

  #packPaper(): void {
    const smooth = this.#flat ? null : (this.composed?.base ?? this.#material.normalMap)
    this.#renderer.others.value!.updatePaper(this.#inputs, this.#material, smooth)
  }

  #patch(mode: WrinkleMode): () => void {
    this.#isComposable = this.#canCompose
    if (mode === 'off') return () => {}
    const material = this.#material
    if (this.#flat) material.normalMap ??= this.#flat
    const refuse = () => {
      this.#isRefused = true
    }
    const { others, patch } = this.#renderer
    const { onCompile } = this.#options
    const patchDefault = () => {
      this.#patched = patch(material, this.#inputs, this.#mesh, { refuse, onCompile })
      return this.#patched.undo
    }
    const undo = {
      composed: () => this.#compose(),
      paper: () => others.value!.patchPaper(material, this.#inputs, refuse).undo,
      default: patchDefault,
      auto: patchDefault,
    }[mode]()
    const undoRelief = this.#patchRelief?.(material)
    return () => {
      this.#auto?.dispose()
      this.#auto = null
      undoRelief?.()
      undo()
      if (material.normalMap === this.#flat) material.normalMap = null
    }
  }

  /** @throws FurrowError when the GPU refuses the shader. */
  #checkShader(renderer: AnyRenderer): void {
    const fault = this.#renderer.faultOf(this.#material, renderer)
    if (fault === null) return
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles',
      what: `the shader of mesh "${this.#mesh.name}" does not compile in the ${this.mode} mode, so it is shown without wrinkles`,
      value: fault,
      remedy:
        this.mode === 'composed'
          ? 'give it another material, such as MeshStandardMaterial'
          : 'use the composed mode, or another material',
    })
  }

  /** Replaces the material's own normal map by the composed one. */
  #compose(): () => void {
    const { others, quads } = this.#renderer
    const { ComposedMap, composeMaterial, composedFormat, drawsLevels } = others.value!
    const base = this.#material.normalMap!
    const { texture } = this.#inputs.textures.normals
    const format = composedFormat(base, texture, drawsLevels)
    const material = composeMaterial(base, this.#inputs, format.level)
    const composed = new ComposedMap(base, format, material, quads.hasContents)
    this.composed = composed
    this.#material.normalMap = composed.target.texture
    return () => {
      this.#material.normalMap = composed.base
      this.composed = null
      composed.dispose()
    }
  }
}

function problemOf(material: WrinkleMaterial): { what: string; remedy: string } | null {
  if (!readsNormalMap(material)) {
    return {
      what: `material ${(material as Material | undefined)?.type} does not support normal maps`,
      remedy: 'use a lit material such as MeshStandardMaterial',
    }
  }
  if (material.normalMap && material.normalMapType === ObjectSpaceNormalMap) {
    return { what: 'object-space normal map', remedy: 'bake it to tangent space' }
  }
  if (patchedMaterials.has(material)) {
    return {
      what: 'the material already shows wrinkles',
      remedy: 'give the mesh its own: mesh.material = mesh.material.clone(), or dispose the other wrinkles',
    }
  }
  return null
}
