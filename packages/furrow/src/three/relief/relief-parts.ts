import type { Material, Mesh } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { Instances } from '../mesh/instances.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { CoarseParts } from './coarse-pass.ts'
import type { ReliefInputs } from './relief-inputs.ts'
import type { ReliefMesh } from './relief-mesh.ts'

/** Renderer-specific parts of relief. */
export interface ReliefParts extends CoarseParts {
  /** Patches a material to displace dense geometries; other geometries are unaffected. Returns a function that undoes the patch. */
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
   * Clones an outline material so that it draws the outline of a dense geometry. The clone follows changes of the original's width and
   * colour. Returns null if unsupported.
   */
  outlineMaterial(
    outline: Material,
    relief: ReliefInputs,
    inputs: ShaderInputs,
    instances: Instances,
  ): Material | null
  /** Runs a function that draws to another target while a shadow is being drawn. */
  duringShadow(renderer: AnyRenderer, draw: () => void): void
}
