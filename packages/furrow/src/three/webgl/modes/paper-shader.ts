import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { includeOf, MAIN, replace, replaceChunk } from '../patch/shader-text.ts'

/**
 * Patches the fragment shader of a built-in material with the method of the paper (docs/paper.md). The shader computes the lighting with the
 * smooth normals and again with the wrinkled normals. It mixes the two colours by the influence of the wrinkles. The patch duplicates the code
 * between the first lighting chunk and the output, whatever this code is. It therefore supports all lit materials of three.js.
 *
 * @param channels number of areas per slice of the texture array.
 * @param diffuseIsSrgb whether the diffuse colours are sRGB-encoded. The shader then decodes them.
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

/** Declares `furrowLinearOf`, which decodes sRGB. The code is `sRGBTransferEOTF` of three.js r170. */
const LINEAR_OF = /* glsl */ `
vec4 furrowLinearOf(vec4 value) {
  vec3 curve = pow(value.rgb * 0.9478672986 + vec3(0.0521327014), vec3(2.4));
  return vec4(mix(curve, value.rgb * 0.0773993808, vec3(lessThanEqual(value.rgb, vec3(0.04045)))), value.a);
}
`

const OUTPUT = '#include <opaque_fragment>'

/** Returns the code of a fragment shader between the first lighting chunk and the output. */
function lightingOf(fragment: string): string {
  const body = fragment.indexOf(MAIN)
  const start = body + fragment.slice(body).search(includeOf('lights_\\w+_fragment'))
  const end = fragment.indexOf(OUTPUT)
  if (start < body || end < 0) throw new Error('#include <lights_..._fragment>')
  return fragment.slice(start, end)
}
