import { ShaderMaterial, type Texture } from 'three'
import type { AutoShaders } from '../../material/auto/auto-shaders.ts'
import type { FirstValues } from '../../material/auto/first-values.ts'
import type { WrinkleTextures } from '../../material/wrinkle-textures.ts'
import { QUAD_SETTINGS } from '../influence/quad-settings.ts'
import { layerNormal } from '../mixing/mix-normals.ts'
import { valueLayers } from '../mixing/value-layers.ts'
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
    pairMaterial('dual', base, normals.texture, normals.slices[0]!, 'vec4(slopeOf(own), slopeOf(layer))'),
  valuesMaterial: (aoMap, { texture, slice }) =>
    pairMaterial('values', aoMap, texture, slice, 'vec4(own.r, layer.rgb)'),
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

/**
 * Draws a map of the material's own and one of a layer into one: `pair` says what of `own` and `layer`. `slopeOf` gives x and y of a normal
 * once it is of unit length.
 */
function pairMaterial(
  name: string,
  own: Texture,
  layers: Texture,
  slice: number,
  pair: string,
): ShaderMaterial {
  return new ShaderMaterial({
    ...QUAD_SETTINGS,
    name: `furrow ${name}`,
    fragmentShader: /* glsl */ `
uniform sampler2D furrowBase;
uniform highp sampler2DArray furrowLayers;
uniform float furrowSlice;
in vec2 targetUv;
out vec4 pair;

vec2 slopeOf(vec4 stored) {
  return normalize(stored.xyz * 2.0 - 1.0).xy * 0.5 + 0.5;
}

void main() {
  vec4 own = texture(furrowBase, targetUv);
  vec4 layer = texture(furrowLayers, vec3(targetUv, furrowSlice));
  pair = ${pair};
}
`,
    uniforms: { furrowBase: { value: own }, furrowLayers: { value: layers }, furrowSlice: { value: slice } },
  })
}

/** Reads the first layer's normal from the texel of the material's own. Of another map than a dual one, it changes nothing. */
function dualFragment(fragment: string, { kinds, normals }: WrinkleTextures): string {
  const [kind] = kinds
  const withZ = kind === 'detail' ? 'furrowHalfWithZ' : 'furrowWithZ'
  const layers = replace(fragment, layerNormal(kind, normals.slices[0]!), `${withZ}( furrowTexel.zw )`)
  const both = kinds.includes('replace') ? layers : layers.replace(/size = sqrt\(.*\)/, 'size = 1.0')
  const shown = replace(both, SAMPLE, `${SAMPLE}\n\tfurrowInfluence *= furrowIsDual;`)
  return `uniform float furrowIsDual;${withTexel(shown)}`
}

/** Reads values of the first layer from the texel of the material's own occlusion. */
function withValues(fragment: string, { kind, slice }: FirstValues, { values }: WrinkleTextures): string {
  const { sampler } = valueLayers(values)[kind]!
  const read = new RegExp(`(furrowTexel_${sampler}_${slice}) = furrowSampleSlice\\([^;]+;`)
  if (!read.test(fragment)) throw new Error(read.source)
  const shared = fragment.replace(read, '$1 = furrowAoTexel.gbaa;')
  const texel = '#ifdef USE_AOMAP\n\tfurrowAoTexel = texture2D( aoMap, vAoMapUv );\n#endif'
  const own = replaceChunk(shared, 'aomap_fragment')
  return `vec4 furrowAoTexel = vec4( 1.0 );${readFirst(own, texel, OWN_AO, 'furrowAoTexel.r', READ_AO)}`
}

/** How three.js reads the map of occlusion. */
const OWN_AO = /texture2D\( *aoMap, *vAoMapUv *\)\.r/

const READ_AO = /\baoMap\s*,/

/** Reads what is mixed already: nothing has influence then. */
function composedFragment(fragment: string, layers: number): string {
  const unmixed = MIXED.reduce<string>((shader, text) => shader.replace(text, ''), fragment)
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

const SAMPLE = 'furrowSampleInfluence(vNormalMapUv);'

const MIXED: (string | RegExp)[] = [SAMPLE, 'furrowReadValues();', /\w+ = furrowMixNormals\(furrowOwn\);/]

/** Reads a texel of the normal map first, and finds z of the material's own normal from it. */
function withTexel(fragment: string): string {
  if (!OWN.test(fragment)) throw new Error(OWN.source)
  const read = '\tfurrowTexel = texture2D( normalMap, vNormalMapUv );'
  return `${TEXEL}${readFirst(fragment, read, OWN, 'furrowWithZ( furrowTexel.xy )', READ)}`
}

/**
 * Reads a texel of a map of the material's own first in `main`, and gives a value of it wherever three.js reads the map.
 *
 * @param others finds what else reads it.
 * @throws Error when something does: what the page's own edit reads of the map must be the material's.
 */
function readFirst(fragment: string, read: string, own: RegExp, value: string, others: RegExp): string {
  const replaced = fragment.replaceAll(new RegExp(own, 'g'), value)
  if (others.test(replaced)) throw new Error(others.source)
  return replace(replaced, MAIN, `${MAIN}\n${read}`)
}

/** How three.js reads the normal map. */
const OWN = /texture2D\( *normalMap, *vNormalMapUv *\)\.xyz \* 2\.0 - 1\.0/

const READ = /\bnormalMap\s*,/

/** Of x and y that are longer than 1, by rounding, z is the root of what they exceed it by: a limit would be one step more. */
const TEXEL = /* glsl */ `
vec4 furrowTexel;
vec3 furrowWithZ(vec2 stored) {
  vec2 xy = stored * 2.0 - 1.0;
  return vec3(xy, sqrt(abs(1.0000002 - dot(xy, xy))));
}

vec3 furrowHalfWithZ(vec2 stored) {
  vec2 xy = stored - 0.5;
  return vec3(stored, sqrt(abs(0.2500001 - dot(xy, xy))));
}
`
