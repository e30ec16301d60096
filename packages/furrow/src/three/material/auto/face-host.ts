import type { QuadMaterials } from '../../atlas/quad-materials.ts'
import type { Channels } from '../channels.ts'
import type { Patch } from '../patch.ts'
import type { ShaderInputs } from '../shader-inputs.ts'
import type { WrinkleMaterial } from '../wrinkle-material.ts'
import type { AutoShaders } from './auto-shaders.ts'
import type { ShownEdit } from './shown-edit.ts'

/** The face that the mode `auto` draws. */
export interface AutoModeHost {
  material: WrinkleMaterial
  inputs: ShaderInputs
  /** What makes the default mode of it. */
  patch: Patch
  /** Whether the material may be drawn by other programs than the default mode's. */
  hasOwnProgram: boolean
  /** Whether layers have other maps than normals. */
  hasValues: boolean
  /** Mix these. */
  channels: Channels | null
  shaders: AutoShaders
  hasContents: QuadMaterials['hasContents']
  /** Bytes that the maps of all faces may take together. */
  budget: number
}

/** The same, for what has maps of it. */
export interface FaceHost extends AutoModeHost {
  shown: ShownEdit
  /** Gives the material its own maps back; called before others are disposed of. */
  end(): void
}
