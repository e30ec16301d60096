import { Fn, float, int, ivec2, Loop, max, min, texture, textureLoad, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { ActivationTable } from '../../material/activation-table.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { inputUniform } from '../node.ts'
import { repeat } from '../texture-sampling.ts'
import { channelMask } from './influence.ts'

/**
 * Computes the influence of all layers in one loop over all areas: per layer, the sum of the areas' weights times their activations. The mode
 * `paper` runs this loop in every pixel, as in step 3 of the paper (see docs/paper.md).
 *
 * @param table activations of the areas.
 * @param uv texture coordinates, which are wrapped into 0..1.
 * @returns influence of layers 0..3 in x, y, z, w, each 0..1.
 */
export function influenceFromAreas(
  { areas }: ShaderInputs,
  table: ActivationTable,
  uv: Node<'vec2'>,
): Node<'vec4'> {
  const count = inputUniform(table.count, 'int')
  return Fn(() => {
    const sum = vec4(0).toVar()
    const largest = vec4(0).toVar()
    const wrapped = repeat(uv).toVar()
    Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i }) => {
      const slice = areas.channels === 1 ? i : i.div(int(4))
      const texel = texture(areas.texture, wrapped).depth(slice).level(int(0))
      const weight = (areas.channels === 1 ? texel.x : texel.dot(channelMask(float(i.mod(int(4)))))).toVar()
      sum.addAssign(textureLoad(table.texture, ivec2(i, int(0))).mul(weight))
      largest.assign(max(largest, textureLoad(table.texture, ivec2(i, int(1))).mul(weight)))
    })
    return max(min(sum, vec4(1)), largest)
  })()
}
