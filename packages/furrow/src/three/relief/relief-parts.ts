import type { Material, Mesh } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { Instances } from '../mesh/instances.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { CoarseParts } from './coarse-pass.ts'
import type { ReliefInputs } from './relief-inputs.ts'
import type { ReliefMesh } from './relief-mesh.ts'

/**
 * Renderer-specific functions of relief. Relief displaces the surface of dense geometries by height maps. A dense geometry is a
 * copy of a mesh's geometry whose triangles are split.
 */
export interface ReliefParts extends CoarseParts {
  /** Patches a material to displace dense geometries. Other geometries stay unchanged. Returns a function that removes the patch. */
  patch(material: Material, relief: ReliefInputs, inputs: ShaderInputs, instances: Instances): () => void
  /** Adds the shadow materials that a relief mesh needs, if any. Returns a function that disposes of them. */
  addShadowMaterials(
    dense: ReliefMesh,
    mesh: Mesh,
    relief: ReliefInputs,
    inputs: ShaderInputs,
    instances: Instances,
  ): () => void
  /**
   * Clones an outline material, and patches the clone to draw the outline of a dense geometry. When the page changes the width or colour of
   * the original outline, the clone changes too. Returns null if unsupported.
   */
  outlineMaterial(
    outline: Material,
    relief: ReliefInputs,
    inputs: ShaderInputs,
    instances: Instances,
  ): Material | null
  /** Called during a shadow pass of three.js. Calls `draw`, which uses another render target, and restores the state of the shadow pass. */
  duringShadow(renderer: AnyRenderer, draw: () => void): void
}
