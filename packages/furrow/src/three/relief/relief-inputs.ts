import type { Texture } from 'three'
import type { HeightMaps } from './height-maps.ts'

/** What the shaders of dense geometries read besides the influence, as uniforms `{ value }`. */
export interface ReliefInputs {
  readonly heights: HeightMaps
  /** Of the meshes' vertices as they are deformed now, see `CoarseParts`. */
  readonly coarse: { positions: Texture; directions: Texture }
  /** Units of the meshes' positions per metre. */
  readonly unitsPerMetre: number
  /** 0 = the coarse mesh, 1 = full relief. */
  readonly amount: { value: number }
  /** Called if a shader turns out to be one that cannot draw it, which is known only when it is compiled. */
  refuse(error: unknown): void
}
