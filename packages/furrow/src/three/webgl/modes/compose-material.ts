import { ShaderMaterial } from 'three'
import type { ComposeMaterial } from '../../material/composed-map.ts'
import { influenceFromMap, sliceSampling } from '../influence/influence.ts'
import { QUAD_SETTINGS } from '../influence/quad-settings.ts'
import { normalMixing } from '../mixing/mix-normals.ts'
import { layerUniforms, mapUniforms } from '../uniforms.ts'

/** Draws the composed normal map with `WebGLRenderer`. */
export const composeMaterial: ComposeMaterial = (base, inputs, level) => {
  const { kinds, normals } = inputs.textures
  const isTexelwise = level !== undefined
  const baseTexel = isTexelwise
    ? 'texelFetch(furrowBase, ivec2(gl_FragCoord.xy), furrowLevel)'
    : 'texture(furrowBase, targetUv)'
  return new ShaderMaterial({
    ...QUAD_SETTINGS,
    name: 'furrow composed',
    fragmentShader: /* glsl */ `${influenceFromMap(kinds.length, 'mesh', false)}
${isTexelwise ? TEXELS : sliceSampling('sampler')}
${normalMixing({ kinds, normals: normals.slices })}
uniform sampler2D furrowBase;
in vec2 targetUv;
out vec4 composed;

void main() {
  furrowSampleInfluence(targetUv);
  vec3 base = ${baseTexel}.xyz * 2.0 - 1.0;
  vec3 mixed = furrowMixNormals(base);
  ${kinds.includes('detail') ? 'mixed = any(greaterThan(furrowInfluence, vec4(0.0))) ? normalize(mixed) : base;' : ''}
  composed = vec4(mixed * 0.5 + 0.5, 1.0);
}
`,
    uniforms: {
      ...mapUniforms(inputs),
      ...layerUniforms(inputs),
      furrowBase: { value: base },
      furrowLevel: level ?? { value: 0 },
    },
  })
}

/** Reads the texel at the target's pixel: all maps have the target's size. */
const TEXELS = /* glsl */ `
uniform int furrowLevel;

vec4 furrowSampleSlice(highp sampler2DArray maps, float slice) {
  return texelFetch(maps, ivec3(gl_FragCoord.xy, slice), furrowLevel);
}
`
