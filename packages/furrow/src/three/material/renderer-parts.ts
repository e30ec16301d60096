import type { Material, Texture } from 'three'
import type { QuadMaterials } from '../atlas/influence-pass.ts'
import type { Instances } from '../instances.ts'
import type { ActivationTable } from './activation-table.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What depends on the renderer. */
export interface RendererParts {
  /** Makes a material show wrinkles, and returns a function that undoes it; the caller sets `needsUpdate`. */
  patch(
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    mode: 'default' | 'paper',
    instances: Instances,
  ): () => void
  /** A material for `Quads` that draws the composed normal map: `base` with the wrinkles mixed in. */
  composeMaterial(base: Texture, inputs: ShaderInputs): Material
  /**
   * A material that shows influence as gray: that of the influence map, or that of a table of activations.
   */
  influenceMaterial(
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    table: ActivationTable | null,
    instances: Instances,
  ): Material
  /** What draws influence maps. */
  quads: QuadMaterials
}
