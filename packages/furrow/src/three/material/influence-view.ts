import type { Material } from 'three'
import type { Area } from '../../core/types.ts'
import type { Instances } from '../mesh/instances.ts'
import type { ActivationTable } from './activation-table.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Inputs of a material that shows the influence map of a face in gray. */
export interface InfluenceView {
  /** Material of the face. Its normal map has the texture coordinates at which the influence map is sampled. */
  wrinkled: Pick<WrinkleMaterial, 'normalMap'>
  inputs: ShaderInputs
  instances: Instances
  /** Names of the areas whose weights are shown instead of the influence map, and the list of all areas. */
  weights?: { areas: readonly Area<unknown>[]; names: readonly string[] } | undefined
}

/**
 * Makes an unlit material show the influence map in gray. If a table of activations is given, the material instead shows the weights of areas
 * times these activations.
 */
export type ShowInfluence = (material: Material, view: InfluenceView, table: ActivationTable | null) => void
