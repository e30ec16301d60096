import type { MixedKind } from '../../../runtime/maps/layer-maps.ts'
import { includeOf, replace, replaceChunk } from '../patch/shader-text.ts'
import { BLOOD_COLOUR, MICRO_SHADOW, TOON_COLOUR, valueMixing, valueReading } from './mix-values.ts'
import { onsetApplication } from './onset.ts'
import type { Values } from './value-layers.ts'

interface EditedShader {
  isToon: boolean
  /** Name of the variable with the mixed normal. */
  normal: string
}

/**
 * GLSL that delays the influence of layers by their onset maps. It then mixes the other value maps (base colour, roughness, occlusion, blood)
 * into the maps of a material, and draws wrinkles as dark lines on toon materials.
 */
export interface AddedValues {
  declarations: string
  /** Statements that `main` runs after it has sampled the influence of the layers. */
  begin: string
  /** Statement that draws lines on toon materials. It compares the mixed normal with the unmixed normal in `furrowOwn`. */
  tint: string
  /** Edits the code that reads the maps of the material. Where the material has no map, the values of layers are mixed into 1. */
  mixOthers(fragment: string): string
}

export function addValues(values: Values, { isToon, normal }: EditedShader): AddedValues {
  const hasValues = Object.keys(values).length > 0
  const { onset, ...mixed } = values
  return {
    declarations: [
      isToon ? TOON_COLOUR : '',
      hasValues ? valueReading(values) : '',
      onset ? onsetApplication(onset) : '',
      ...Object.entries(mixed).map(([kind, layers]) => valueMixing(kind as MixedKind, layers)),
      values.occlusion ? MICRO_SHADOW : '',
      values.blood ? BLOOD_COLOUR : '',
    ].join(''),
    begin: [
      hasValues ? 'furrowReadValues();' : '',
      ...(onset ? ['furrowApplyOnset();'] : []),
      values.occlusion ? 'furrowOcclude( furrowMix_occlusion( 1.0 ) );' : '',
    ].join('\n\t'),
    tint: isToon ? `diffuseColor.rgb = furrowToonColour(diffuseColor.rgb, furrowOwn, ${normal});` : '',
    mixOthers: (fragment) => mixOthers(fragment, values),
  }
}

function mixOthers(fragment: string, { baseColor, roughness, occlusion, blood }: Values): string {
  let shader = fragment
  // This edit must precede the next one, which replaces the same include.
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

/**
 * Edits the lighting so that the occlusion of layers darkens specular highlights of lights. three.js itself darkens only reflections of
 * environment maps.
 */
function shadowHighlights(chunk: string): string {
  const highlight = 'reflectedLight.directSpecular += irradiance *'
  return `float furrowMicroShadow( highp float cosine );\n${replace(chunk, highlight, `${highlight} furrowMicroShadow( dotNL ) *`)}`
}
