import { ShaderMaterial } from 'three'
import type { AutoShaders } from '../../material/auto/auto-shaders.ts'
import type { FirstValues } from '../../material/auto/first-values.ts'
import type { WrinkleTextures } from '../../material/wrinkle-textures.ts'
import { QUAD_SETTINGS } from '../influence/quad-settings.ts'
import type { ShaderEdit } from '../patch/patch-shader.ts'
import { MAIN, replace, replaceChunk } from '../patch/shader-text.ts'
import { bloodRange, occlusionMaterial } from './compose-material.ts'

/** What the mode `auto` takes on `WebGLRenderer`: edits of the default mode's fragment shader. */
export const AUTO_SHADERS: Omit<AutoShaders, 'composeMaterial'> = {
  occlusionMaterial,
  composedEdit(_material, { textures }, { patch, refuse }): ShaderEdit {
    const { key, apply } = patch.edit as ShaderEdit
    return {
      key: `${key} composed`,
      uniforms: {},
      apply(shader) {
        apply(shader)
        shader.fragmentShader = composedFragment(shader.fragmentShader, textures.kinds.length)
      },
      refuse,
    }
  },
  dualMaterial: (base, { normals }) =>
    new ShaderMaterial({
      ...QUAD_SETTINGS,
      name: 'furrow dual',
      fragmentShader: DUAL,
      uniforms: {
        furrowBase: { value: base },
        furrowNormals: { value: normals.texture },
        furrowSlice: { value: normals.slices[0] },
      },
    }),
  valuesMaterial: (aoMap, { texture, slice }) =>
    new ShaderMaterial({
      ...QUAD_SETTINGS,
      name: 'furrow values',
      fragmentShader: VALUES,
      uniforms: {
        furrowBase: { value: aoMap },
        furrowValues: { value: texture },
        furrowSlice: { value: slice },
      },
    }),
  dualEdit(_material, { textures }, { patch, isDual, values, refuse }): ShaderEdit {
    const { key, apply } = patch.edit as ShaderEdit
    return {
      key: `${key} dual ${values ? 'values' : ''}`,
      uniforms: { furrowIsDual: isDual },
      apply(shader) {
        apply(shader)
        const dual = dualFragment(shader.fragmentShader, textures)
        shader.fragmentShader = values ? withValues(dual, values, textures) : dual
      },
      refuse,
    }
  },
}

/** x and y of both normals, once they are of unit length. */
const DUAL = /* glsl */ `
uniform sampler2D furrowBase;
uniform highp sampler2DArray furrowNormals;
uniform float furrowSlice;
in vec2 targetUv;
out vec4 dual;

vec2 slopeOf(vec4 stored) {
  return normalize(stored.xyz * 2.0 - 1.0).xy * 0.5 + 0.5;
}

void main() {
  vec4 layer = texture(furrowNormals, vec3(targetUv, furrowSlice));
  dual = vec4(slopeOf(texture(furrowBase, targetUv)), slopeOf(layer));
}
`

/** The material's own occlusion, and the layer's values. */
const VALUES = /* glsl */ `
uniform sampler2D furrowBase;
uniform highp sampler2DArray furrowValues;
uniform float furrowSlice;
in vec2 targetUv;
out vec4 values;

void main() {
  values = vec4(texture(furrowBase, targetUv).r, texture(furrowValues, vec3(targetUv, furrowSlice)).rgb);
}
`

/** Reads the first layer's normal from the texel of the material's own. Of another map than a dual one, it changes nothing. */
function dualFragment(fragment: string, { normals }: WrinkleTextures): string {
  const layer = `furrowSampleSlice(furrowNormals, ${normals.slices[0]}.0).xyz * 2.0 - 1.0`
  const both = replace(fragment, layer, 'furrowWithZ( furrowTexel.zw )')
  const [sample] = SAMPLED
  const shown = replace(both, sample, `${sample}\n\tfurrowInfluence *= furrowIsDual;`)
  return `uniform float furrowIsDual;${withTexel(shown)}`
}

/** Reads values of the first layer from the texel of the material's own occlusion. */
function withValues(fragment: string, { texture, slice }: FirstValues, { values }: WrinkleTextures): string {
  const [sampler] = Object.entries(values).find(([, maps]) => maps.texture === texture)!
  const read = new RegExp(`if \\([^;]+\\) (furrowTexel_${sampler}_${slice}) = furrowSampleSlice\\([^;]+;`)
  if (!read.test(fragment)) throw new Error(read.source)
  const shared = fragment.replace(read, '$1 = furrowAoTexel.gbaa;')
  const own = replaceChunk(shared, 'aomap_fragment').replaceAll(OWN_AO, 'furrowAoTexel.r')
  if (READ_AO.test(own)) throw new Error(READ_AO.source)
  const texel = '\n#ifdef USE_AOMAP\n\tfurrowAoTexel = texture2D( aoMap, vAoMapUv );\n#endif'
  return `vec4 furrowAoTexel = vec4( 1.0 );${replace(own, MAIN, `${MAIN}${texel}`)}`
}

/** How three.js reads the map of occlusion. */
const OWN_AO = /texture2D\( *aoMap, *vAoMapUv *\)\.r/g

const READ_AO = /\baoMap\s*,/

/** Reads what is mixed already: nothing has influence then. */
function composedFragment(fragment: string, layers: number): string {
  const unmixed = SAMPLED.reduce((shader, text) => shader.replace(text, ''), fragment)
  const occluded = unmixed.replace(
    'furrowOcclude( furrowMix_occlusion( 1.0 ) )',
    'furrowOcclude( furrowTexel.z )',
  )
  const flushed = occluded.replace(
    'float blood = furrowMix_blood(0.0)',
    `float blood = furrowBloodOf(furrowTexel.w) * ${bloodRange(layers)}`,
  )
  return withTexel(flushed)
}

const SAMPLED = ['furrowSampleInfluence(vNormalMapUv);', 'furrowReadValues();']

/** Reads a texel of the normal map first, and finds z of the material's own normal from it. */
function withTexel(fragment: string): string {
  if (!OWN.test(fragment)) throw new Error(OWN.source)
  const own = fragment.replaceAll(new RegExp(OWN, 'g'), 'furrowWithZ( furrowTexel.xy )')
  // What the page's own edit reads of the map must be the normal.
  if (READ.test(own)) throw new Error(READ.source)
  const read = 'furrowTexel = texture2D( normalMap, vNormalMapUv );'
  return `${TEXEL}${replace(own, MAIN, `${MAIN}\n\t${read}`)}`
}

/** How three.js reads the normal map. */
const OWN = /texture2D\( *normalMap, *vNormalMapUv *\)\.xyz \* 2\.0 - 1\.0/

const READ = /\bnormalMap\s*,/

const TEXEL = /* glsl */ `
vec4 furrowTexel;
vec3 furrowWithZ(vec2 stored) {
  vec2 xy = stored * 2.0 - 1.0;
  return vec3(xy, sqrt(max(1.0 - dot(xy, xy), 1e-6)));
}
`
