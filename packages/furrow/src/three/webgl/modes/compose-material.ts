import { ShaderMaterial, type Texture } from 'three'
import { BLOOD_AT_REST } from '../../../core/blood.ts'
import type { Channels } from '../../material/channels.ts'
import type { ComposeMaterial } from '../../material/composed-map.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { influenceFromMap, sliceSampling } from '../influence/influence.ts'
import { QUAD_SETTINGS } from '../influence/quad-settings.ts'
import { normalMixing } from '../mixing/mix-normals.ts'
import { type AddedChannels, type ShaderChannels, type Values, valueLayers } from '../mixing/value-layers.ts'
import { layerUniforms, mapUniforms } from '../uniforms.ts'

/** Draws the composed normal map on `WebGLRenderer`. */
export const composeMaterial: ComposeMaterial = (base, inputs, level, channels) => {
  const { kinds, normals, values } = inputs.textures
  const layers = valueLayers(values)
  const added = addedTo(layers, channels)
  const isTexelwise = level !== undefined
  const own = isTexelwise
    ? 'texelFetch(furrowBase, ivec2(gl_FragCoord.xy), furrowLevel)'
    : 'texture(furrowBase, targetUv)'
  const composed = added
    ? `vec4(normalize(mixed).xy * 0.5 + 0.5, ${storedValues(layers, kinds.length)})`
    : 'vec4(mixed * 0.5 + 0.5, 1.0)'
  return quadMaterial('furrow composed', base, inputs, {
    declarations: [
      influenceFromMap(kinds.length, 'mesh', false),
      isTexelwise ? TEXELS : sliceSampling('sampler'),
      normalMixing({ kinds, normals: normals.slices }),
      added?.declarations,
    ],
    uniforms: { furrowLevel: level ?? { value: 0 } },
    main: /* glsl */ `${added?.begin ?? ''}
  vec3 base = ${own}.xyz * 2.0 - 1.0;
  vec3 mixed = furrowMixNormals(base);
  ${kinds.includes('detail') ? 'mixed = any(greaterThan(furrowInfluence, vec4(0.0))) ? normalize(mixed) : base;' : ''}
  composed = ${composed};`,
  })
}

/** Draws a map of occlusion with that of the layers. */
export function occlusionMaterial(aoMap: Texture, inputs: ShaderInputs, channels: Channels): ShaderMaterial {
  const { kinds, values } = inputs.textures
  const added = addedTo(valueLayers(values), channels)!
  return quadMaterial('furrow occlusion', aoMap, inputs, {
    declarations: [
      influenceFromMap(kinds.length, 'mesh', false),
      sliceSampling('sampler'),
      added.declarations,
    ],
    uniforms: {},
    main: /* glsl */ `${added.begin}
  composed = vec4(furrowMix_occlusion(texture(furrowBase, targetUv).r), 0.0, 0.0, 1.0);`,
  })
}

function addedTo(layers: Values, channels: Channels | null | undefined): AddedChannels | null {
  return channels ? (channels as ShaderChannels).add(layers, { isToon: false, normal: '' }) : null
}

/** The layers' visibility and blood, as `composedEdit` reads them. */
function storedValues({ occlusion, blood }: Values, layers: number): string {
  const visibility = occlusion ? 'furrowVisibility' : '1.0'
  const share = blood ? `clamp(furrowMix_blood(0.0) / ${bloodRange(layers)}, -1.0, 1.0)` : '0.0'
  return `${visibility}, (${BLOOD_AT_REST}.0 + ${255 - BLOOD_AT_REST}.0 * ${share}) / 255.0`
}

/** The largest amplitude of the layers' blood, in GLSL. */
export function bloodRange(layers: number): string {
  const amplitudes = Array.from({ length: layers }, (_, layer) => `furrowBloodAmplitude[${layer}]`)
  return amplitudes.reduce((range, amplitude) => `max(${range}, ${amplitude})`, '0.0001')
}

interface QuadShader {
  declarations: (string | undefined)[]
  uniforms: ShaderMaterial['uniforms']
  /** Writes `composed`, from `furrowBase` at `targetUv`. */
  main: string
}

function quadMaterial(
  name: string,
  base: Texture,
  inputs: ShaderInputs,
  { declarations, uniforms, main }: QuadShader,
): ShaderMaterial {
  return new ShaderMaterial({
    ...QUAD_SETTINGS,
    name,
    fragmentShader: /* glsl */ `${declarations.join('')}
uniform sampler2D furrowBase;
in vec2 targetUv;
out vec4 composed;

void main() {
  furrowSampleInfluence(targetUv);
  ${main}
}
`,
    uniforms: {
      ...mapUniforms(inputs),
      ...layerUniforms(inputs),
      furrowBase: { value: base },
      ...uniforms,
    },
  })
}

/** A pixel of the target is a texel of that level. */
const TEXELS = /* glsl */ `
uniform int furrowLevel;

vec4 furrowSampleSlice(highp sampler2DArray maps, float slice) {
  return texelFetch(maps, ivec3(gl_FragCoord.xy, slice), furrowLevel);
}
`
