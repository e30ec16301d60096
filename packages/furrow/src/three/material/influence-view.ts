import type { Material } from 'three'
import type { Area } from '../../core/types.ts'
import type { Instances } from '../mesh/instances.ts'
import type { ActivationTable } from './activation-table.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Inputs of a material that shows influence as gray. */
export interface InfluenceView {
  /** Material of the wrinkled face. Its normal map determines which texture coordinates are used. */
  wrinkled: Pick<WrinkleMaterial, 'normalMap'>
  inputs: ShaderInputs
  instances: Instances
  /** Areas whose weights are shown. Default: the current influence. */
  weights?: { areas: readonly Area<unknown>[]; names: readonly string[] } | undefined
}

/** Makes an unlit material show the influence map as gray, or, if a table is given, areas by their activations in the table. */
export type ShowInfluence = (material: Material, view: InfluenceView, table: ActivationTable | null) => void
