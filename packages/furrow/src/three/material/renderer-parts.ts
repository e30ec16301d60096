import type { Material, Mesh } from 'three'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import type { ReliefParts } from '../relief/relief-parts.ts'
import type { AnyRenderer, Entry } from '../renderer.ts'
import type { BindTension } from '../sources/tension.ts'
import type { Channels } from './channels.ts'
import type { Fetched } from './fetched.ts'
import type { OtherModes } from './other-modes.ts'
import type { PatchEvents, ShownMode } from './patch.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What depends on the renderer. */
export interface RendererParts {
  /** The entry of the package that it belongs to. */
  entry: Entry
  /** Whether the material's shader is known to be one that `patch` can edit; if not, the composed mode shows its wrinkles. */
  canPatch(material: WrinkleMaterial): boolean
  /**
   * Makes a material show wrinkles in the default mode; the caller calls `renew` then, and when that is undone.
   *
   * @param meshes of the face.
   * @param events what is known only when the shader is compiled.
   */
  patch(
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    meshes: readonly Mesh[],
    events: PatchEvents,
  ): ShownMode
  /** Makes the renderer build the material's shader anew, with the uniforms that it has now. */
  renew(material: Material): void
  /**
   * Why the GPU does not accept the material's shader, as far as the renderer knows by now; null if nothing is wrong. Called before the
   * material is drawn, in every frame.
   */
  faultOf(material: Material, renderer: AnyRenderer): string | null
  /** Whether nothing must be drawn now, in the midst of a compilation; what draws influence is then compiled with the first frame. */
  isCompiling?(renderer: AnyRenderer): boolean
  /** The other modes, and what shows influence: fetched, since most pages show the default mode only. */
  others: Fetched<OtherModes>
  /** What mixes other maps than normals: fetched for layers that have any. */
  channels: Fetched<Channels>
  /** A black one, without lights and tone mapping. */
  unlitMaterial(): Material
  /** Measures the tension of the skin. */
  bindTension: BindTension
  /** What draws influence maps. */
  quads: QuadMaterials
  /** What draws relief, loaded when it is first wanted. */
  loadRelief(): Promise<ReliefParts>
}
