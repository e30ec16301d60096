import type { Material } from 'three'
import type { Area } from '../../core/types.ts'
import type { Instances } from '../mesh/instances.ts'
import type { ActivationTable } from './activation-table.ts'
import type { ComposedMap, ComposeMaterial, composedFormat } from './composed-map.ts'
import type { Patch } from './patch.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { updatePaper } from './update-paper.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What the modes `paper`, `composed` and `auto` take on a renderer, and what shows influence. */
export interface OtherModes {
  updatePaper: typeof updatePaper
  /** As `RendererParts.patch`, for the paper's mode. */
  patchPaper(material: WrinkleMaterial, inputs: ShaderInputs, refuse: () => void): Patch
  ComposedMap: typeof ComposedMap
  composedFormat: typeof composedFormat
  /**
   * Whether the composed mode draws all levels of its map, only where areas move: on a software rasteriser that takes half of what
   * the GPU takes to make them, each of them whole. Where a pass is dear, the GPU makes them.
   */
  drawsLevels: boolean
  composeMaterial: ComposeMaterial
  /** Makes an unlit material show influence as gray. */
  showInfluence(material: Material, view: InfluenceView): void
}

/** What is shown as gray. */
export interface InfluenceView {
  /** Its normal map has the texture coordinates. */
  wrinkled: Pick<WrinkleMaterial, 'normalMap'>
  inputs: ShaderInputs
  instances: Instances
  /** The weights of some areas; by default, the current influence. */
  weights?: { areas: readonly Area<unknown>[]; names: readonly string[] } | undefined
}

/** Shows influence as gray by a renderer's shaders: that of the influence map, or that of a table of activations. */
export type ShowInfluence = (material: Material, view: InfluenceView, table: ActivationTable | null) => void
