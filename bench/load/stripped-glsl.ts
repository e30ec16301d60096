import { ShaderChunk } from 'three'
import { BLOOD, type StrippedMaps, type StrippedPatch } from './stripped.ts'

/** For `WebGLRenderer`. */
export const strippedPatch: StrippedPatch = (material, maps) => {
  material.onBeforeCompile = (shader) => {
    for (const name of Object.keys(maps) as (keyof StrippedMaps)[])
      shader.uniforms[name] = { value: maps[name] }
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', `${DECLARATIONS}\nvoid main() {\n${SAMPLES}`)
      .replace('#include <map_fragment>', `#include <map_fragment>\n${FLUSH}`)
      .replace('#include <aomap_fragment>', OCCLUSION)
      .replace('#include <normal_fragment_maps>', NORMALS)
  }
}

const DECLARATIONS = /* glsl */ `
uniform sampler2D strippedNormals;
uniform sampler2D strippedSurface;
uniform sampler2D strippedInfluence;
`

const SAMPLES = /* glsl */ `
  float influence = texture2D(strippedInfluence, vNormalMapUv).r;
  vec3 wrinkle = texture2D(strippedNormals, vNormalMapUv).xyz * 2.0 - 1.0;
  vec4 surface = texture2D(strippedSurface, vNormalMapUv);
`

const FLUSH = /* glsl */ `
  float blood = influence * (surface.b * 255.0 - 128.0) / 127.0;
  diffuseColor.rgb *= exp(-blood * vec3(${BLOOD.join(', ')}));
`

const OCCLUSION = ShaderChunk.aomap_fragment.replace(
  'texture2D( aoMap, vAoMapUv ).r',
  'mix(texture2D( aoMap, vAoMapUv ).r, surface.r, influence)',
)

/** Reoriented normal mapping, of any length. */
const NORMALS = ShaderChunk.normal_fragment_maps.replace(
  'mapN.xy *= normalScale;',
  /* glsl */ `
  vec3 lifted = mapN + vec3(0.0, 0.0, 1.0);
  vec3 turned = vec3(wrinkle.xy * (-influence / wrinkle.z), 1.0);
  mapN = lifted * dot(lifted, turned) / lifted.z - turned;
  mapN.xy *= normalScale;`,
)
