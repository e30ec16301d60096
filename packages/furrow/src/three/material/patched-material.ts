import type { Material, Mesh, Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import { checkNotInstanced } from '../mesh/check-mesh.ts'
import { instancesOf } from '../mesh/instances.ts'
import type { WrinkleMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'
import { patchedMaterials } from './check-material.ts'
import { createInfluenceMaterial } from './influence-material.ts'
import type { InfluenceView } from './influence-view.ts'
import { showMode } from './modes.ts'
import type { ModeHost, ShownMode } from './patch.ts'
import type { RendererParts } from './renderer-parts.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import { withSurface } from './surface.ts'
import { flatNormalTexture } from './textures.ts'
import { updatePaper } from './update-paper.ts'
import { cloneByClass, type WrinkleMaterial } from './wrinkle-material.ts'

/** A user's material, patched to show wrinkles. */
export class PatchedMaterial {
  mode: WrinkleMode = 'off'
  readonly #meshes: readonly Mesh[]
  readonly #material: WrinkleMaterial
  readonly #inputs: ShaderInputs
  readonly #renderer: RendererParts
  /** Flat normal map, used while the material has none of its own. */
  readonly #flat: Texture
  /** Patches the material to draw relief; null without relief. */
  #patchRelief: ((material: Material) => () => void) | null = null
  #undoRelief: (() => void) | undefined
  readonly #influenceMaterials = new WeakSet<Material>()
  /** Number of materials that show the current influence. While there are any, the influence map is updated in every mode. */
  views = 0
  /** Whether the shader turned out not to be patchable. */
  #isRefused = false
  /** Patch of the current mode; null while the material is plain. */
  #shown: ShownMode | null = null
  /** Whether the material is kept plain in every mode. */
  #isSuspended = false
  /** Whether this object, rather than the page, is disposing of the material. */
  #isRenewing = false
  readonly #onCompile: ModeHost['onCompile']
  readonly #onDisposed: () => void

  /**
   * @param meshes live list of the face's meshes; call `follow` after adding one.
   * @param onDisposed called when the page disposes of the material.
   */
  constructor(
    meshes: readonly Mesh[],
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    renderer: RendererParts,
    onCompile: ModeHost['onCompile'],
    onDisposed: () => void,
  ) {
    this.#onDisposed = () => this.#isRenewing || onDisposed()
    this.#onCompile = onCompile
    this.#meshes = meshes
    this.#material = material
    this.#inputs = inputs
    this.#renderer = renderer
    this.#flat = flatNormalTexture(material.normalMap)
    // three.js writes the name into a one-line shader directive, which line breaks and trailing backslashes would break.
    material.name &&= material.name.replace(/[\r\n\\]/g, ' ')
    patchedMaterials.add(material)
    material.addEventListener('dispose', this.#onDisposed)
  }

  /** Phase 5 of a frame, in modes that need it. */
  get update(): ShownMode['update'] {
    return this.#shown?.update
  }

  /**
   * Changes the mode. Falls back from `default` to `composed` if the material cannot be patched.
   *
   * @throws FurrowError if the mode is unsupported here; the mode then stays unchanged.
   */
  show(requested: WrinkleMode): void {
    const mode = requested === 'default' && !this.#isPatchable ? 'composed' : requested
    if (mode === 'paper' && !this.#isPatchable) {
      throw new FurrowError({
        code: 'unsupported',
        who: 'Wrinkles.mode',
        problem: "the material's shader cannot be patched",
        value: mode,
        limit: 'composed or off',
        remedy: 'use the composed mode',
      })
    }
    if (mode === 'paper' || mode === 'composed') checkNotInstanced(this.#mesh, mode)
    if (mode === 'paper') this.#packPaper()
    this.#apply(mode)
  }

  /**
   * Called before each frame, because the result of compilation is known only after the first one. Falls back to the composed mode if
   * the shader could not be patched. Turns wrinkles off, with one warning, if the shader does not compile.
   *
   * @param renderer null between frames.
   */
  settle(renderer: AnyRenderer | null): void {
    if (this.mode === 'off') return
    try {
      // The page may remove or replace the normal map, change other maps, or add faces.
      const { normalMap } = this.#material
      const isReplaced = !normalMap || (this.#shown?.composed ?? normalMap) !== normalMap
      if (isReplaced || this.#shown?.isCurrent?.() === false) this.#apply(this.mode)
      if (this.#isRefused && this.mode !== 'composed') this.show('default')
      if (this.mode === 'paper') this.#packPaper()
      if (renderer) this.#checkShader(renderer)
    } catch (error) {
      this.show('off')
      console.warn((error as Error).message)
    }
  }

  /** Sets the relief patch, which applies in all modes but `off`; null for none. */
  setRelief(patch: ((material: Material) => () => void) | null): void {
    this.#patchRelief = patch
    if (this.mode !== 'off') this.#apply(this.mode)
  }

  /** Called when a mesh is added to the face. */
  follow(mesh: Mesh): void {
    if (this.#shown?.supportsMesh?.(mesh) === false) this.#apply(this.mode)
  }

  /** Clones the material without wrinkles. */
  clone(): Material {
    this.#unpatch()
    const copy = cloneByClass(this.#material)
    this.#patch(this.mode)
    return copy
  }

  /** Returns the mesh's `material` value in which the wrinkled material is cloned, without wrinkles. */
  cloneAll(): Material | Material[] {
    return withSurface(this.#mesh, this.#material, this.clone())
  }

  /** Creates a material that shows influence as gray. */
  influenceMaterial(weights?: InfluenceView['weights']): Material {
    const wrinkled = { normalMap: this.#material.normalMap ?? this.#flat }
    const view = { wrinkled, inputs: this.#inputs, instances: instancesOf(this.#mesh), weights }
    const material = createInfluenceMaterial(view, this.#renderer)
    this.#influenceMaterials.add(material)
    if (!weights) {
      this.views++
      material.addEventListener('dispose', () => this.views--)
    }
    return material
  }

  /** Makes the material plain until `resume`, and frees the resources of its mode. */
  suspend(): void {
    this.#isSuspended = true
    this.#apply(this.mode)
    this.#flat.dispose()
  }

  resume(): void {
    this.#isSuspended = false
    this.show(this.mode)
  }

  dispose(): void {
    this.#material.removeEventListener('dispose', this.#onDisposed)
    this.show('off')
    this.#flat.dispose()
    patchedMaterials.delete(this.#material)
    // Renderers cache uniforms with the material; wrinkles added later need their own.
    this.#material.dispose()
  }

  /** Whether a mesh uses the material, or a material that shows its influence. */
  isOn({ material }: Mesh): boolean {
    if (Array.isArray(material)) return material.includes(this.#material)
    return material === this.#material || this.#influenceMaterials.has(material)
  }

  get material(): Material {
    return this.#material
  }

  /** Mesh that the wrinkles were created with. */
  get #mesh(): Mesh {
    return this.#meshes[0]
  }

  get #isPatchable(): boolean {
    return !this.#isRefused && this.#renderer.canPatch(this.#material)
  }

  #apply(mode: WrinkleMode): void {
    this.#unpatch()
    this.#patch(mode)
    this.#isRenewing = true
    this.#renderer.renew(this.#material)
    this.#isRenewing = false
    this.mode = mode
  }

  #packPaper(): void {
    const map = this.#shown?.base ?? this.#material.normalMap
    updatePaper(this.#inputs, this.#material, map === this.#flat ? null : map)
  }

  #patch(mode: WrinkleMode): void {
    if (mode === 'off' || this.#isSuspended) return
    const material = this.#material
    material.normalMap ??= this.#flat
    const refuse = () => {
      this.#isRefused = true
    }
    const host: ModeHost = {
      material,
      inputs: this.#inputs,
      meshes: this.#meshes,
      refuse,
      onCompile: this.#onCompile,
    }
    this.#shown = showMode(mode, host, this.#renderer)
    this.#undoRelief = this.#patchRelief?.(material)
  }

  #unpatch(): void {
    if (!this.#shown) return
    this.#undoRelief?.()
    this.#shown.undo()
    this.#shown = null
    if (this.#material.normalMap === this.#flat) this.#material.normalMap = null
  }

  /** Turns wrinkles off if the shader does not compile. */
  #checkShader(renderer: AnyRenderer): void {
    const shaderError = this.#renderer.shaderErrorOf(this.#material, renderer)
    if (shaderError === null) return
    const { mode } = this
    this.show('off')
    warnOfShaderError(this.#mesh, mode, shaderError)
  }
}

function warnOfShaderError({ name }: Mesh, mode: WrinkleMode, shaderError: string): void {
  const { message } = new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    problem: `the shader of mesh "${name}" does not compile in the ${mode} mode, so its wrinkles are off`,
    value: shaderError,
    remedy:
      mode === 'composed'
        ? 'use another material, such as MeshStandardMaterial'
        : 'use the composed mode, or another material',
  })
  console.warn(message)
}
