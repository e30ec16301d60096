import type { Texture } from 'three'
import type { HeightMaps } from './height-maps.ts'

/** Uniforms of the relief shaders, besides `ShaderInputs`. */
export interface ReliefInputs {
  readonly heights: HeightMaps
  /** Deformed vertices of the meshes, see `CoarseParts`. */
  readonly coarse: { positions: Texture; directions: Texture }
  /** Units of the meshes' positions per metre. */
  readonly unitsPerMetre: number
  /** 0 = the coarse mesh, 1 = full relief. */
  readonly amount: { value: number }
  /** Called while compiling a shader that turns out not to support relief. */
  refuse(error: unknown): void
}
