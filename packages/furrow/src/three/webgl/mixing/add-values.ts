import type { ValueKind } from '../../material/wrinkle-textures.ts'
import { includeOf, replace, replaceChunk } from '../patch/shader-text.ts'
import { BLOOD_COLOUR, MICRO_SHADOW, TOON_COLOUR, valueMixing, valueReading } from './mix-values.ts'
import type { Values } from './value-layers.ts'

interface EditedShader {
  isToon: boolean
  /** The variable of the mixed normal. */
  normal: string
}

/** The parts of a shader that mix the layers' other maps in, and draw wrinkles as lines on materials that light in steps. */
export interface AddedValues {
  declarations: string
  /** First in `main`, behind the influence. */
  begin: string
  /** Behind the mixed normal, beside `furrowOwn`. */
  tint: string
  /** Mixes into the material's own maps where it reads them; without a map its own value is 1. */
  mixOthers(fragment: string): string
}

/** Mixes the layers' other maps, and draws the lines of a material that lights in steps. */
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

/** See `AddedValues`. */
function mixOthers(fragment: string, { baseColor, roughness, occlusion, blood }: Values): string {
  let shader = fragment
  // Before the edit below, which replaces the include.
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

/** Highlights of lights are shadowed by the layers' occlusion; those of the surroundings are by three.js. */
function shadowHighlights(chunk: string): string {
  const highlight = 'reflectedLight.directSpecular += irradiance *'
  return `float furrowMicroShadow( highp float cosine );\n${replace(chunk, highlight, `${highlight} furrowMicroShadow( dotNL ) *`)}`
}
