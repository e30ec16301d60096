import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { includeOf, MAIN, replace, replaceChunk } from '../patch/shader-text.ts'

/**
 * The paper's shader on a built-in material: light with smooth normals, light again with wrinkled ones, mix
 * the two colours by the influence. The material's own text between its first lighting chunk and its output
 * is run twice, so that it works for any of three.js's lit materials.
 *
 * @param channels of a slice that hold areas.
 * @param diffuseIsSrgb whether the diffuse slice of the array is sampled as stored, and is decoded here.
 */
export function paperFragment(fragment: string, channels: 1 | 4, diffuseIsSrgb: boolean): string {
  const lighting = lightingOf(fragment)
  const smoothRead = 'vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;'
  const bothRead = /* glsl */ `
  vec3 furrowWrinkled = texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 2.0)).xyz * 2.0 - 1.0;
  furrowWrinkled.xy *= normalScale;
  furrowWrinkled = normalize(tbn * furrowWrinkled);
  vec3 mapN = texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 1.0)).xyz * 2.0 - 1.0;`
  const litTwice = /* glsl */ `${lighting}
  vec3 furrowOutgoingLight = outgoingLight;
  {
    normal = furrowWrinkled;
    reflectedLight = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    #ifdef USE_CLEARCOAT
      clearcoatSpecularDirect = vec3(0.0);
      clearcoatSpecularIndirect = vec3(0.0);
    #endif
    #ifdef USE_SHEEN
      sheenSpecularDirect = vec3(0.0);
      sheenSpecularIndirect = vec3(0.0);
    #endif
    ${lighting}
    furrowOutgoingLight = mix(furrowOutgoingLight, outgoingLight, furrowInfluenceFromAreas(vNormalMapUv).x);
  }
  outgoingLight = furrowOutgoingLight;
`
  const stored = 'texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 0.0))'
  const diffuse = `diffuseColor *= ${diffuseIsSrgb ? `furrowLinearOf(${stored})` : stored};`
  const declarations = `${influenceFromAreas(channels)}\nuniform highp sampler2DArray furrowColours;\n${LINEAR_OF}`
  const coloured = replaceChunk(replaceChunk(fragment, 'normal_fragment_maps'), 'map_fragment', () => diffuse)
  return [
    [MAIN, `${declarations}\n${MAIN}`],
    [smoothRead, bothRead],
    [lighting, litTwice],
  ].reduce((shader, [text, replacement]) => replace(shader, text, replacement), coloured)
}

/** Decodes sRGB as three.js does from r170 on, in its `sRGBTransferEOTF`. */
const LINEAR_OF = /* glsl */ `
vec4 furrowLinearOf(vec4 value) {
  vec3 curve = pow(value.rgb * 0.9478672986 + vec3(0.0521327014), vec3(2.4));
  return vec4(mix(curve, value.rgb * 0.0773993808, vec3(lessThanEqual(value.rgb, vec3(0.04045)))), value.a);
}
`

const OUTPUT = '#include <opaque_fragment>'

/** The text of a material's fragment shader that lights it. */
function lightingOf(fragment: string): string {
  const body = fragment.indexOf(MAIN)
  const start = body + fragment.slice(body).search(includeOf('lights_\\w+_fragment'))
  const end = fragment.indexOf(OUTPUT)
  if (start < body || end < 0) throw new Error('#include <lights_..._fragment>')
  return fragment.slice(start, end)
}
