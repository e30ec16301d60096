import type { Material } from 'three'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import type { CreateRelief } from '../relief/relief-control.ts'
import type { AnyRenderer, Entry } from '../renderer.ts'
import type { BindTension } from '../sources/tension.ts'
import type { ComposeMaterial } from './composed-map.ts'
import type { ShowInfluence } from './influence-view.ts'
import type { ModeHost, ShownMode } from './patch.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Renderer-specific parts of wrinkles. */
export interface RendererParts {
  entry: Entry
  /** Whether the material's shader can be patched; otherwise the composed mode is used. */
  canPatch(material: WrinkleMaterial): boolean
  showDefault(host: ModeHost): ShownMode
  showPaper(host: ModeHost): ShownMode
  composeMaterial: ComposeMaterial
  /**
   * Whether the composed mode draws all mip levels itself, limited to changed areas. On a software rasteriser that takes half as long as
   * generating complete mipmaps. False where render passes are expensive.
   */
  drawsLevels: boolean
  showInfluence: ShowInfluence
  /** Makes the renderer rebuild the material's shader with its current uniforms. */
  renew(material: Material): void
  /** Compile error of the material's shader, or null if none is known yet. Called before every draw. */
  shaderErrorOf(material: Material, renderer: AnyRenderer): string | null
  /** Whether a compilation is running, during which nothing may be drawn. */
  isCompiling?(renderer: AnyRenderer): boolean
  /** Creates a black material without lights and tone mapping. */
  unlitMaterial(): Material
  bindTension: BindTension
  /** Materials of the influence atlas. */
  quads: QuadMaterials
  /** Downloads the code for relief when a face first needs it. Most pages never show a face that large. */
  loadRelief(): Promise<CreateRelief>
}
