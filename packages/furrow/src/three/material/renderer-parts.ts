import type { Material } from 'three'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import type { CreateRelief } from '../relief/relief-control.ts'
import type { AnyRenderer, Entry } from '../renderer.ts'
import type { BindTension } from '../sources/tension.ts'
import type { ComposeMaterial } from './composed-map.ts'
import type { ShowInfluence } from './influence-view.ts'
import type { ModeHost, ShownMode } from './patch.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Functions and values that differ between `WebGLRenderer` and `WebGPURenderer`. */
export interface RendererParts {
  entry: Entry
  /** Whether the shader of a material can be patched. Otherwise the mode `composed` is used. */
  canPatch(material: WrinkleMaterial): boolean
  showDefault(host: ModeHost): ShownMode
  showPaper(host: ModeHost): ShownMode
  composeMaterial: ComposeMaterial
  /**
   * Whether the mode `composed` draws the changed areas in every mip level, instead of generating all mipmaps from the first level. On a
   * software rasteriser this takes half as long, but it needs one render pass per level.
   */
  drawsLevels: boolean
  showInfluence: ShowInfluence
  /** Makes the renderer rebuild the shader of a material with its current uniforms. */
  renew(material: Material): void
  /** Returns the compile error of a material's shader, or null if there is none or compilation is not finished. Called before every draw. */
  shaderErrorOf(material: Material, renderer: AnyRenderer): string | null
  /** Whether the renderer is compiling a scene without drawing it. The influence map must not be drawn meanwhile. */
  isCompiling?(renderer: AnyRenderer): boolean
  /** Creates a black material that ignores lights and tone mapping. */
  unlitMaterial(): Material
  bindTension: BindTension
  quads: QuadMaterials
  /** Downloads the code for relief. Called only when a face first needs relief, because most pages need none. */
  loadRelief(): Promise<CreateRelief>
}
