import type { Material, Texture } from 'three'
import type { QuadMaterials } from '../atlas/influence-pass.ts'
import type { Instances } from '../instances.ts'
import type { ActivationTable } from './activation-table.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What a renderer's class adds. */
export interface RendererParts {
  /** Makes a material show wrinkles, and returns what takes that back; `needsUpdate` is set by the caller. */
  patch(
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    mode: 'default' | 'paper',
    instances: Instances,
  ): () => void
  /** A material of `Quads` that writes the material's own normal map with the wrinkles in it. */
  composeMaterial(base: Texture, inputs: ShaderInputs): Material
  /**
   * A material that shows the influence of another's wrinkles as gray: that of the map, or that of a table of
   * its own.
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
