/** What the occlusion and the blood of the shipped face take besides: they are in one image. */
import { ShaderChunk } from 'three'
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../packages/furrow/src/core/blood.ts'
import type { FloorChannels } from './floor.ts'

/** For `floorPlugin`. Occlusion is in R, blood in B. */
export const surfaceChannels: FloorChannels = {
  textureOf: ({ occlusionTexture }) => occlusionTexture,
  edit(shader) {
    const { aomap_fragment: occlusion, lights_physical_pars_fragment: lights } = ShaderChunk
    const sample = 'texture2D( aoMap, vAoMapUv ).r'
    const highlight = 'reflectedLight.directSpecular += irradiance *'
    return shader
      .replace('#include <map_fragment>', `#include <map_fragment>${BLOOD}`)
      .replace('#include <aomap_fragment>', occlusion.replace(sample, `mix(${sample}, surface.r, influence)`))
      .replace(
        '#include <lights_physical_pars_fragment>',
        MICRO_SHADOW + lights.replace(highlight, `${highlight} microShadow(dotNL) *`),
      )
  },
}

/** Highlights fall into occluded places only from above. */
const MICRO_SHADOW = /* glsl */ `
uniform sampler2D floorValues;
uniform float floorAmplitude;
float cone = 0.0;
float microShadow(float cosine) {
  return cosine * cosine < cone ? cosine * cosine / cone : 1.0;
}
`

const BLOOD = /* glsl */ `
vec4 surface = texture2D(floorValues, vNormalMapUv);
cone = influence * (1.0 - surface.r);
float steps = surface.b * 255.0 - ${BLOOD_AT_REST}.0;
if (abs(steps) >= ${BLOOD_THRESHOLD})
  diffuseColor.rgb *= exp(-influence * floorAmplitude * steps / 127.0 * vec3(${BLOOD_ABSORPTION}));
`
