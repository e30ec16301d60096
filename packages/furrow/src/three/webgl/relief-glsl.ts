import { CANCELLED, PHONG, ROOM_TO_CURVE } from '../../relief/displaced.ts'
import type { HeightLayer } from '../relief/height-maps.ts'
import { INFLUENCE_LOOKUP } from './influence-glsl.ts'

/** Vertices at one position at most whose normals are averaged: a guard, not a limit that meshes meet. */
const MOST_TWINS = 16

/** What a program with relief depends on. */
export interface ReliefVariant {
  heights: readonly HeightLayer[]
  /** Channel of the heights' texture. */
  channel: number
  isInstanced: boolean
}

/**
 * Declares functions of a vertex of a dense geometry, see `displace` of the room `relief`; `furrowIsDense` tells whether it is one.
 * Vertices at a seam read the same numbers in the same order, so that they stay together to the bit.
 */
export function reliefFunctions({ heights, channel, isInstanced }: ReliefVariant): string {
  const displacement = heights.map(
    ({ layer, slice, amplitude }) =>
      `+ influence[${layer}] * (textureLod(furrowHeights, vec3(at, ${slice}.0), 0.0)[${channel}] - 0.5) * ${amplitude.toExponential()}`,
  )
  return /* glsl */ `
in vec3 furrowParents;
in vec3 furrowCorners;
in vec3 furrowWeights;
in vec4 furrowUvs;
in float furrowRoom;
uniform highp sampler2D furrowCoarsePositions;
uniform highp sampler2D furrowCoarseDirections;
uniform highp sampler2DArray furrowHeights;
uniform float furrowUnitsPerMetre;
uniform float furrowAmount;
${INFLUENCE_LOOKUP}
bool furrowIsDense() {
  return furrowWeights.x + furrowWeights.y + furrowWeights.z > 0.0;
}

vec4 furrowCoarse(highp sampler2D values, float vertex) {
  int i = int(vertex);
  int width = textureSize(values, 0).x;
  return texelFetch(values, ivec2(i % width, i / width), 0);
}

vec3 furrowUnpack(vec2 octahedral) {
  vec3 v = vec3(octahedral, 1.0 - abs(octahedral.x) - abs(octahedral.y));
  if (v.z < 0.0) v.xy = (1.0 - abs(v.yx)) * vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0);
  return normalize(v);
}

vec3 furrowCoarseNormal(float vertex) {
  return furrowUnpack(furrowCoarse(furrowCoarseDirections, vertex).xy);
}

vec3 furrowShadingNormal() {
  return furrowCoarseNormal(furrowCorners.x) * furrowWeights.x
    + furrowCoarseNormal(furrowCorners.y) * furrowWeights.y
    + furrowCoarseNormal(furrowCorners.z) * furrowWeights.z;
}

vec3 furrowShadingTangent() {
  return furrowUnpack(furrowCoarse(furrowCoarseDirections, furrowCorners.x).zw) * furrowWeights.x
    + furrowUnpack(furrowCoarse(furrowCoarseDirections, furrowCorners.y).zw) * furrowWeights.y
    + furrowUnpack(furrowCoarse(furrowCoarseDirections, furrowCorners.z).zw) * furrowWeights.z;
}

vec3 furrowSmoothNormal(float first, float next) {
  vec3 own = furrowCoarseNormal(first);
  vec3 sum = own;
  for (int i = 0; i < ${MOST_TWINS} && next != first; i++) {
    sum += furrowCoarseNormal(next);
    next = furrowCoarse(furrowCoarsePositions, next).w;
  }
  return normalize(dot(sum, sum) > ${(CANCELLED ** 2).toExponential()} ? sum : own);
}

float furrowDisplacement(vec2 at) {
  vec4 influence = furrowLookUp(at, furrowGrid.z + ${isInstanced ? 'float(gl_InstanceID)' : '0.0'});
  at = furrowRepeat(at);
  return 0.0 ${displacement.join(' ')};
}

vec3 furrowSurface() {
  vec4 a = furrowCoarse(furrowCoarsePositions, furrowParents.x);
  vec4 b = furrowCoarse(furrowCoarsePositions, furrowParents.y);
  vec4 c = furrowCoarse(furrowCoarsePositions, furrowParents.z);
  vec3 na = furrowSmoothNormal(furrowParents.x, a.w);
  vec3 nb = furrowSmoothNormal(furrowParents.y, b.w);
  vec3 nc = furrowSmoothNormal(furrowParents.z, c.w);
  vec3 w = furrowWeights;
  vec3 flatPoint = a.xyz * w.x + b.xyz * w.y + c.xyz * w.z;
  vec3 curve = dot(flatPoint - a.xyz, na) * na * w.x + dot(flatPoint - b.xyz, nb) * nb * w.y + dot(flatPoint - c.xyz, nc) * nc * w.z;
  float curved = ${PHONG.toFixed(2)} * furrowAmount * min(furrowRoom / ${ROOM_TO_CURVE.toExponential()}, 1.0);
  float height = (furrowDisplacement(furrowUvs.xy) + furrowDisplacement(furrowUvs.zw)) * 0.5;
  vec3 direction = normalize(na * w.x + nb * w.y + nc * w.z);
  float outwards = clamp(height, -furrowRoom, furrowRoom) * furrowAmount * furrowUnitsPerMetre;
  return flatPoint - curve * curved + direction * outwards;
}
`
}
