import type { Material, Mesh } from 'three'
import type { QuadMaterials } from '../atlas/influence-pass.ts'
import type { Instances } from '../instances.ts'
import type { ReliefParts } from '../relief/relief-parts.ts'
import type { AnyRenderer, Entry } from '../renderer.ts'
import type { ActivationTable } from './activation-table.ts'
import type { Fetched } from './fetched.ts'
import type { OtherModes } from './other-modes.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What a patched material calls when its shader is compiled. */
export interface PatchEvents {
  /** The shader cannot be edited after all; it then stays as it was. */
  refuse(): void
  /** On `WebGLRenderer`, which in `compile` does nothing else that is done before a mesh is drawn. */
  onCompile(renderer: AnyRenderer): void
}

/** What depends on the renderer. */
export interface RendererParts {
  /** The entry of the package that it belongs to. */
  entry: Entry
  /** Whether the material's shader is known to be one that `patch` can edit; if not, the composed mode shows its wrinkles. */
  canPatch(material: WrinkleMaterial): boolean
  /**
   * Makes a material show wrinkles in the default mode, and returns a function that undoes it; the caller calls `renew` after either.
   *
   * @param events what is known only when the shader is compiled.
   */
  patch(material: WrinkleMaterial, inputs: ShaderInputs, mesh: Mesh, events: PatchEvents): () => void
  /** Makes the renderer build the material's shader anew, with the uniforms that it has now. */
  renew(material: Material): void
  /**
   * Why the GPU does not accept the material's shader, as far as the renderer knows by now; null if nothing is wrong. Called before the
   * material is drawn, in every frame.
   */
  faultOf(material: Material, renderer: AnyRenderer): string | null
  /** The other modes: fetched, since most pages show the default one only. */
  others: Fetched<OtherModes>
  /**
   * A material that shows influence as gray: that of the influence map, or that of a table of activations.
   *
   * @param material its normal map has the texture coordinates.
   */
  influenceMaterial(
    material: Pick<WrinkleMaterial, 'normalMap'>,
    inputs: ShaderInputs,
    table: ActivationTable | null,
    instances: Instances,
  ): Material
  /** What draws influence maps. */
  quads: QuadMaterials
  /** What draws relief, loaded when it is first wanted. */
  loadRelief(): Promise<ReliefParts>
}
