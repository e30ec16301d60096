import { ShaderMaterial } from 'three'
import type { ComposeMaterial } from '../../material/composed-map.ts'
import { influenceFromMap, sliceSampling } from '../influence/influence.ts'
import { QUAD_SETTINGS } from '../influence/quad-settings.ts'
import { normalMixing } from '../mixing/mix-normals.ts'
import { valueReading } from '../mixing/mix-values.ts'
import { onsetApplication, onsetOf } from '../mixing/onset.ts'
import { valueLayers } from '../mixing/value-layers.ts'
import { layerUniforms, mapUniforms } from '../uniforms.ts'

/**
 * Creates the material that draws the composed normal map with `WebGLRenderer`. The map is the normal map of a material, mixed with the normals
 * of the wrinkles.
 */
export const composeMaterial: ComposeMaterial = (base, inputs, level) => {
  const { kinds, normals, values } = inputs.textures
  const ofOnset = onsetOf(valueLayers(values))
  const isTexelwise = level !== undefined
  const baseTexel = isTexelwise
    ? 'texelFetch(furrowBase, ivec2(gl_FragCoord.xy), furrowLevel)'
    : 'texture(furrowBase, targetUv)'
  return new ShaderMaterial({
    ...QUAD_SETTINGS,
    name: 'furrow composed',
    fragmentShader: /* glsl */ `${influenceFromMap(kinds.length, 'mesh', false)}
${isTexelwise ? TEXELS : sliceSampling('sampler')}
${ofOnset.onset ? `${sliceSampling('sampler', 'furrowSampleOnset')}${valueReading(ofOnset, 'furrowSampleOnset')}${onsetApplication(ofOnset.onset)}` : ''}
${normalMixing({ kinds, normals: normals.slices })}
uniform sampler2D furrowBase;
in vec2 targetUv;
out vec4 composed;

void main() {
  furrowSampleInfluence(targetUv);
  ${ofOnset.onset ? 'furrowReadValues();\n  furrowApplyOnset();' : ''}
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

/** Reads the texel of a map at the position of the pixel that is drawn. The maps and the render target must have the same size. */
const TEXELS = /* glsl */ `
uniform int furrowLevel;

vec4 furrowSampleSlice(highp sampler2DArray maps, float slice) {
  return texelFetch(maps, ivec3(gl_FragCoord.xy, slice), furrowLevel);
}
`
