import type { Material, Mesh } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { Instances } from '../mesh/instances.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { CoarseParts } from './coarse-pass.ts'
import type { ReliefInputs } from './relief-inputs.ts'
import type { ReliefMesh } from './relief-mesh.ts'

/** What relief needs of a renderer. */
export interface ReliefParts extends CoarseParts {
  /** Makes a material draw dense geometries in their places too; returns what undoes that. Any other geometry is drawn as before. */
  patch(material: Material, relief: ReliefInputs, inputs: ShaderInputs, instances: Instances): () => void
  /** Gives what is drawn in place of a mesh the materials that its shadow needs, if any; returns what frees them. */
  dressShadow(
    dense: ReliefMesh,
    mesh: Mesh,
    relief: ReliefInputs,
    inputs: ShaderInputs,
    instances: Instances,
  ): () => void
  /**
   * Creates a copy of a material that draws the outline of a mesh, which draws that of a dense geometry, and has the widths and colours of the
   * other, also when these change; null where there can be none.
   */
  outlineMaterial(
    own: Material,
    relief: ReliefInputs,
    inputs: ShaderInputs,
    instances: Instances,
  ): Material | null
  /** Runs something that draws elsewhere while a shadow is being drawn. */
  duringShadow(renderer: AnyRenderer, draw: () => void): void
}
