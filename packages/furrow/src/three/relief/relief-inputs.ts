import type { Texture } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { HeightMaps } from './height-maps.ts'

/** Inputs of shaders that displace a surface by height maps, in addition to `ShaderInputs`. */
export interface ReliefInputs {
  readonly heights: HeightMaps
  /** Textures with the deformed vertices of the original meshes, see `CoarseParts`. */
  readonly coarse: { positions: Texture; directions: Texture }
  /** Units of the meshes' positions per metre. */
  readonly unitsPerMetre: number
  /** Strength of the displacement: 0 = surface of the original mesh, 1 = full. */
  readonly amount: { value: number }
  /** Called during the compilation of a shader if it cannot be patched for relief. */
  refuse(error: unknown): void
}

/** Returns the number of mipmap levels by which the onset maps are larger than the height maps; negative if they are smaller. */
export function onsetLevels({ textures }: ShaderInputs, { heights }: ReliefInputs): number {
  const widthOf = ({ image }: Texture) => (image as { width: number }).width
  const { onset } = textures.values
  return onset ? Math.log2(widthOf(onset.texture) / widthOf(heights.texture)) : 0
}
