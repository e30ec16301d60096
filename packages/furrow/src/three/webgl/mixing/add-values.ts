import type { ValueKind } from '../../material/wrinkle-textures.ts'
import { includeOf, replace, replaceChunk } from '../patch/shader-text.ts'
import { BLOOD_COLOUR, MICRO_SHADOW, TOON_COLOUR, valueMixing, valueReading } from './mix-values.ts'
import type { Values } from './value-layers.ts'

interface EditedShader {
  isToon: boolean
  /** Variable of the mixed normal. */
  normal: string
}

/** GLSL that mixes the layers' value maps, and draws wrinkle lines on toon materials. */
export interface AddedValues {
  declarations: string
  /** Statements at the start of `main`, after the influence. */
  begin: string
  /** Statement after the mixed normal, where `furrowOwn` is declared. */
  tint: string
  /** Mixes values into the material's maps where the shader reads them. Without a map the material's value is 1. */
  mixOthers(fragment: string): string
}

/** Creates the GLSL of the layers' value maps, and of toon lines. */
export function addValues(values: Values, { isToon, normal }: EditedShader): AddedValues {
  const hasValues = Object.keys(values).length > 0
  return {
    declarations: [
      isToon ? TOON_COLOUR : '',
      hasValues ? valueReading(values) : '',
      ...Object.entries(values).map(([kind, layers]) => valueMixing(kind as ValueKind, layers)),
      values.occlusion ? MICRO_SHADOW : '',
      values.blood ? BLOOD_COLOUR : '',
    ].join(''),
    begin: [
      hasValues ? 'furrowReadValues();' : '',
      values.occlusion ? 'furrowOcclude( furrowMix_occlusion( 1.0 ) );' : '',
    ].join('\n\t'),
    tint: isToon ? `diffuseColor.rgb = furrowToonColour(diffuseColor.rgb, furrowOwn, ${normal});` : '',
    mixOthers: (fragment) => mixOthers(fragment, values),
  }
}

function mixOthers(fragment: string, { baseColor, roughness, occlusion, blood }: Values): string {
  let shader = fragment
  // Must precede the next edit, which replaces the include.
  if (blood) {
    shader = shader.replace(
      includeOf('map_fragment'),
      (include) => `${include}\n\tdiffuseColor.rgb = furrowBloodColour( diffuseColor.rgb );`,
    )
  }
  if (baseColor) {
    shader = replaceChunk(shader, 'map_fragment', (chunk) => {
      const withMap = replace(
        chunk,
        'diffuseColor *= sampledDiffuseColor;',
        'sampledDiffuseColor.rgb = furrowMix_baseColor( sampledDiffuseColor.rgb );\n\tdiffuseColor *= sampledDiffuseColor;',
      )
      return `${withMap}\n#ifndef USE_MAP\n\tdiffuseColor.rgb *= furrowMix_baseColor( vec3( 1.0 ) );\n#endif\n`
    })
  }
  if (roughness) {
    shader = replaceChunk(shader, 'roughnessmap_fragment', (chunk) => {
      const withMap = replace(
        chunk,
        'roughnessFactor *= texelRoughness.g;',
        'roughnessFactor *= furrowMix_roughness( texelRoughness.g );',
      )
      return `${withMap}\n#ifndef USE_ROUGHNESSMAP\n\troughnessFactor *= furrowMix_roughness( 1.0 );\n#endif\n`
    })
  }
  if (occlusion) {
    shader = replaceChunk(shader, 'aomap_fragment', (chunk) => {
      const sample = 'texture2D( aoMap, vAoMapUv ).r'
      const withMap = replace(chunk, sample, `furrowMix_occlusion( ${sample} )`)
      const scaled = `( ${sample} - 1.0 ) * aoMapIntensity + 1.0`
      const withoutMap = replace(chunk, scaled, 'furrowVisibility')
      return `${withMap}\n${replace(withoutMap, '#ifdef USE_AOMAP', '#ifndef USE_AOMAP')}`
    })
    for (const name of ['lights_physical_pars_fragment', 'lights_phong_pars_fragment'] as const) {
      shader = replaceChunk(shader, name, shadowHighlights)
    }
  }
  return shader
}

/** Shadows the specular highlights of lights by the layers' occlusion. three.js does so for environment maps. */
function shadowHighlights(chunk: string): string {
  const highlight = 'reflectedLight.directSpecular += irradiance *'
  return `float furrowMicroShadow( highp float cosine );\n${replace(chunk, highlight, `${highlight} furrowMicroShadow( dotNL ) *`)}`
}
