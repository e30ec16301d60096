import type { Material } from 'three'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import type { CreateRelief } from '../relief/relief-control.ts'
import type { AnyRenderer, Entry } from '../renderer.ts'
import type { BindTension } from '../sources/tension.ts'
import type { ComposeMaterial } from './composed-map.ts'
import type { ShowInfluence } from './influence-view.ts'
import type { ModeHost, ShownMode } from './patch.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What depends on the renderer. */
export interface RendererParts {
  /** The entry of the package that it belongs to. */
  entry: Entry
  /** Whether the material's shader is known to be one that can be edited; if not, the composed mode shows its wrinkles. */
  canPatch(material: WrinkleMaterial): boolean
  showDefault(host: ModeHost): ShownMode
  showPaper(host: ModeHost): ShownMode
  composeMaterial: ComposeMaterial
  /**
   * Whether the composed mode draws all levels of its map, only where areas move: on a software rasteriser that takes half of what
   * the GPU takes to make them, each of them whole. Where a pass is dear, the GPU makes them.
   */
  drawsLevels: boolean
  showInfluence: ShowInfluence
  /** Makes the renderer build the material's shader again, with the uniforms that it has now. */
  renew(material: Material): void
  /**
   * Why the GPU does not accept the material's shader, as far as the renderer knows by now; null if nothing is wrong. Called before the
   * material is drawn, in every frame.
   */
  faultOf(material: Material, renderer: AnyRenderer): string | null
  /** Whether nothing must be drawn now, in the midst of a compilation; what draws influence is then compiled with the first frame. */
  isCompiling?(renderer: AnyRenderer): boolean
  /** A black one, without lights and tone mapping. */
  unlitMaterial(): Material
  /** Measures the tension of the skin. */
  bindTension: BindTension
  /** What draws influence maps. */
  quads: QuadMaterials
  /** Relief is a lazy chunk: most faces are never large enough on screen to need it. */
  loadRelief(): Promise<CreateRelief>
}
