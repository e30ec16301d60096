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

/** A material of the page whose shader is patched to show wrinkles. */
export class PatchedMaterial {
  mode: WrinkleMode = 'off'
  readonly #meshes: readonly Mesh[]
  readonly #material: WrinkleMaterial
  readonly #inputs: ShaderInputs
  readonly #renderer: RendererParts
  /**
   * Flat normal map. Used while the page has set no normal map, because patches read the texture coordinates of the normal map, and three.js
   * provides them only for materials with a normal map.
   */
  readonly #flat: Texture
  /** Patches the material to draw relief, i.e. to displace the surface by height maps; null without relief. */
  #patchRelief: ((material: Material) => () => void) | null = null
  #undoRelief: (() => void) | undefined
  readonly #influenceMaterials = new WeakSet<Material>()
  /** Number of materials that show the influence map. While it is above 0, the influence map is updated in every mode. */
  views = 0
  /** Whether patching the shader has failed. */
  #isRefused = false
  /** Patch of the current mode; null while the material is not patched. */
  #shown: ShownMode | null = null
  /** Whether the material stays unpatched in every mode. */
  #isSuspended = false
  /** True while this object calls `dispose` of the material to rebuild its shader. Other `dispose` calls come from the page. */
  #isRenewing = false
  readonly #onCompile: ModeHost['onCompile']
  readonly #onDisposed: () => void

  /**
   * @param meshes meshes of the face. Call `follow` after adding a mesh to this list.
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
    // three.js copies the name into a `#define`. A line break would end it, and a trailing backslash would continue it in the next line.
    material.name &&= material.name.replace(/[\r\n\\]/g, ' ')
    patchedMaterials.add(material)
    material.addEventListener('dispose', this.#onDisposed)
  }

  /** Updates textures of the current mode in each frame, see `ShownMode`; undefined if the mode has no such textures. */
  get update(): ShownMode['update'] {
    return this.#shown?.update
  }

  /**
   * Changes the mode. If the shader cannot be patched, `default` becomes `composed`.
   *
   * @throws FurrowError if the mode is unsupported for the mesh or material; the mode then stays unchanged.
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
   * Called in each frame, because a failure to patch or compile the shader is known only after the first draw. If the shader could not be
   * patched, changes to the mode `composed`. If the shader does not compile, turns wrinkles off with one warning.
   *
   * @param renderer renderer of the frame; null between frames.
   */
  settle(renderer: AnyRenderer | null): void {
    if (this.mode === 'off') return
    try {
      // The page may remove, replace or transform the normal map, change other maps, or add faces to the influence atlas.
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

  /** Sets the patch that draws relief in all modes except `off`; null removes it. */
  setRelief(patch: ((material: Material) => () => void) | null): void {
    this.#patchRelief = patch
    if (this.mode !== 'off') this.#apply(this.mode)
  }

  /** Called when a mesh is added to the face. Rebuilds the shader if it does not support the mesh. */
  follow(mesh: Mesh): void {
    if (this.#shown?.supportsMesh?.(mesh) === false) this.#apply(this.mode)
  }

  /** Clones the material without its wrinkles. */
  clone(): Material {
    this.#unpatch()
    const copy = cloneByClass(this.#material)
    this.#patch(this.mode)
    return copy
  }

  /** Returns the value of `mesh.material`, with a clone in place of the patched material. The clone has no wrinkles. */
  cloneAll(): Material | Material[] {
    return withSurface(this.#mesh, this.#material, this.clone())
  }

  /**
   * Creates a material that shows the influence map in gray.
   *
   * @param weights if given, the material shows the weights of these areas instead.
   */
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

  /** Removes the patch until `resume`, and frees the resources of the mode. */
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
    // Renderers cache the uniforms of a material, and would use the old uniforms for wrinkles that are added later.
    this.#material.dispose()
  }

  /** Whether a mesh has the patched material, or a material from `influenceMaterial`. */
  isOn({ material }: Mesh): boolean {
    if (Array.isArray(material)) return material.includes(this.#material)
    return material === this.#material || this.#influenceMaterials.has(material)
  }

  get material(): Material {
    return this.#material
  }

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
