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

/** The user's own material while it shows wrinkles. */
export class PatchedMaterial {
  /** What is shown. */
  mode: WrinkleMode = 'off'
  readonly #meshes: readonly Mesh[]
  readonly #material: WrinkleMaterial
  readonly #inputs: ShaderInputs
  readonly #renderer: RendererParts
  /** The normal map while it shows wrinkles and has none of its own, as from the start or since the page took it away. */
  readonly #flat: Texture
  /** Makes the material draw relief too; null while there is none. */
  #patchRelief: ((material: Material) => () => void) | null = null
  #undoRelief: (() => void) | undefined
  /** Materials that show influence. */
  readonly #influenceMaterials = new WeakSet<Material>()
  /** How many materials show the current influence, which needs the map in any mode. */
  views = 0
  /** Whether the shader turned out to be one that cannot be patched. */
  #isRefused = false
  /** What makes it show the mode; null while it is plain. */
  #shown: ShownMode | null = null
  /** Whether it stays plain in every mode. */
  #isSuspended = false
  /** Whether this object, and not the page, disposes of the material now. */
  #isRenewing = false
  readonly #onCompile: ModeHost['onCompile']
  readonly #onDisposed: () => void

  /**
   * @param meshes of the face: a list that may grow, see `follow`.
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
    // three.js writes the name into a line of the shader, which another line end, or a backslash before its own, would break.
    material.name &&= material.name.replace(/[\r\n\\]/g, ' ')
    patchedMaterials.add(material)
    material.addEventListener('dispose', this.#onDisposed)
  }

  /** Phase 5 of a frame, in modes that take activations then. */
  get update(): ShownMode['update'] {
    return this.#shown?.update
  }

  /**
   * Changes the mode. A material that cannot be patched shows the composed mode instead of the
   * default one.
   *
   * @throws FurrowError when the mode is not possible; it then stays as it was.
   */
  show(wanted: WrinkleMode): void {
    const mode = wanted === 'default' && !this.#isPatchable ? 'composed' : wanted
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
   * Called before each frame, since only the first one tells what becomes of the shader: a material that could not be patched shows
   * the composed mode from the second on, and one whose shader the GPU refuses is plain again, with one warning.
   *
   * @param renderer null between frames.
   */
  settle(renderer: AnyRenderer | null): void {
    if (this.mode === 'off') return
    try {
      // The page may take its map away, put another one where the composed map was, change which maps it has, or add faces.
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

  /** Makes the material draw relief too, in all modes but `off`; null for none. */
  setRelief(patch: ((material: Material) => () => void) | null): void {
    this.#patchRelief = patch
    if (this.mode !== 'off') this.#apply(this.mode)
  }

  /** Called when the face has another mesh. */
  follow(mesh: Mesh): void {
    if (this.#shown?.isFor?.(mesh) === false) this.#apply(this.mode)
  }

  /** Copies the material without wrinkles. */
  clone(): Material {
    this.#unpatch()
    const copy = cloneByClass(this.#material)
    this.#patch(this.mode)
    return copy
  }

  /** Copies what the mesh has as its material, without wrinkles; of several materials only the one that shows them. */
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

  /** Makes the material plain until `resume`, and frees everything that its mode needs. */
  suspend(): void {
    this.#isSuspended = true
    this.#apply(this.mode)
    this.#flat.dispose()
  }

  /** Shows the mode again. */
  resume(): void {
    this.#isSuspended = false
    this.show(this.mode)
  }

  /** Restores the material. */
  dispose(): void {
    this.#material.removeEventListener('dispose', this.#onDisposed)
    this.show('off')
    this.#flat.dispose()
    patchedMaterials.delete(this.#material)
    // Renderers cache uniforms with the material; wrinkles added later need their own.
    this.#material.dispose()
  }

  /** Whether a mesh has the material, or one that shows its influence. */
  isOn({ material }: Mesh): boolean {
    if (Array.isArray(material)) return material.includes(this.#material)
    return material === this.#material || this.#influenceMaterials.has(material)
  }

  /** The user's own. */
  get material(): Material {
    return this.#material
  }

  /** The one that the wrinkles were added to. */
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

  /** Makes a material plain whose shader the GPU refuses. */
  #checkShader(renderer: AnyRenderer): void {
    const fault = this.#renderer.faultOf(this.#material, renderer)
    if (fault === null) return
    const { mode } = this
    this.show('off')
    warnOfFault(this.#mesh, mode, fault)
  }
}

function warnOfFault({ name }: Mesh, mode: WrinkleMode, fault: string): void {
  const { message } = new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    problem: `the shader of mesh "${name}" does not compile in the ${mode} mode, so it is shown without wrinkles`,
    value: fault,
    remedy:
      mode === 'composed'
        ? 'give it another material, such as MeshStandardMaterial'
        : 'use the composed mode, or another material',
  })
  console.warn(message)
}
