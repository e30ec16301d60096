import type { IUniform } from 'three'
import type { ActivationTable } from '../../material/activation-table.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { REPEAT } from './influence.ts'

/**
 * Returns GLSL that computes the influence of all layers in one loop over all areas: per layer, the sum of the areas' weights times their
 * activations. The mode `paper` runs this loop in every pixel, as in step 3 of the paper (see docs/paper.md).
 *
 * @param channels number of areas per slice of the texture array.
 */
export function influenceFromAreas(channels: 1 | 4): string {
  const weight = channels === 1 ? 'texel.r' : 'texel[i % 4]'
  const slice = channels === 1 ? 'i' : 'i / 4'
  return /* glsl */ `${REPEAT}
uniform highp sampler2DArray furrowAreas;
uniform highp sampler2D furrowActivations;
uniform int furrowAreaCount;

vec4 furrowInfluenceFromAreas(vec2 unwrapped) {
  vec2 uv = furrowRepeat(unwrapped);
  vec4 sum = vec4(0.0);
  vec4 largest = vec4(0.0);
  for (int i = 0; i < furrowAreaCount; i++) {
    vec4 texel = textureLod(furrowAreas, vec3(uv, float(${slice})), 0.0);
    float weight = ${weight};
    sum += weight * texelFetch(furrowActivations, ivec2(i, 0), 0);
    largest = max(largest, weight * texelFetch(furrowActivations, ivec2(i, 1), 0));
  }
  return max(min(sum, 1.0), largest);
}
`
}

/** Returns the uniforms of the code from `influenceFromAreas`. */
export function areaUniforms(inputs: ShaderInputs, table: ActivationTable): Record<string, IUniform> {
  return {
    furrowAreas: inputs.areaTexture,
    furrowActivations: { value: table.texture },
    furrowAreaCount: table.count,
  }
}
