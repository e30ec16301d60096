import { CANCELLED, CLEARANCE_TO_CURVE, PHONG } from '../../../relief/displaced.ts'
import type { ValueLayers } from '../../../runtime/maps/value-texels.ts'
import type { HeightLayer } from '../../relief/height-maps.ts'
import { CORNER_OF_INSTANCE, INFLUENCE_LOOKUP } from '../influence/influence.ts'
import { ONSET_INFLUENCE } from '../mixing/onset.ts'

/** Maximum number of normals that are averaged at one position. It limits a loop in the shader; real meshes have fewer normals there. */
const MAX_TWINS = 16

/** Parameters of a shader that displaces a surface by height maps. */
export interface ReliefVariant {
  heights: readonly HeightLayer[]
  /** Channel of the height texture. */
  channel: number
  isInstanced: boolean
  /**
   * Onset maps of the layers, if any. `levels` is added to the mipmap level of height maps to get the mipmap level of onset maps. It is
   * `log2(a / b)`, where `a` is the width of onset maps and `b` the width of height maps.
   */
  onset?: ValueLayers & { levels: number }
}

/**
 * Returns GLSL with functions for the vertex shader. They place the vertices of a dense geometry, i.e. a geometry with split triangles, on the
 * deformed triangles of the original mesh, and displace them by height maps. The reference implementation is `displace` in src/relief.
 * `furrowIsDense` returns false for other geometries. Copies of a vertex at a seam read the same numbers in the same order. Their displaced
 * positions are therefore bit-identical, and the surface has no cracks.
 */
export function reliefFunctions({ heights, channel, isInstanced, onset }: ReliefVariant): string {
  const displacement = heights.map(
    ({ layer, slice, amplitude }) =>
      `+ ${influenceOf(layer, onset)} * (textureLod(furrowHeights, vec3(at, ${slice}.0), furrowLevel)[${channel}] - 0.5) * ${amplitude.toExponential()}`,
  )
  return /* glsl */ `
in vec3 furrowParents;
in vec3 furrowCorners;
in vec3 furrowWeights;
in vec4 furrowUvs;
in float furrowClearance;
in float furrowLevel;
uniform highp sampler2D furrowCoarsePositions;
uniform highp sampler2D furrowCoarseDirections;
uniform highp sampler2DArray furrowHeights;
uniform float furrowUnitsPerMetre;
uniform float furrowAmount;
${onset ? `uniform highp sampler2DArray furrow_${onset.sampler};${ONSET_INFLUENCE}` : ''}${INFLUENCE_LOOKUP}${isInstanced ? CORNER_OF_INSTANCE : ''}
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

/** Normals and tangents of the three corners. Corners with weight 0 are not read. */
vec4 furrowDirections[3];

void furrowReadDirections() {
  furrowDirections[0] = furrowCoarse(furrowCoarseDirections, furrowCorners.x);
  furrowDirections[1] = furrowDirections[2] = furrowDirections[0];
  if (furrowWeights.y > 0.0) furrowDirections[1] = furrowCoarse(furrowCoarseDirections, furrowCorners.y);
  if (furrowWeights.z > 0.0) furrowDirections[2] = furrowCoarse(furrowCoarseDirections, furrowCorners.z);
}

vec3 furrowShadingNormal() {
  return furrowUnpack(furrowDirections[0].xy) * furrowWeights.x
    + furrowUnpack(furrowDirections[1].xy) * furrowWeights.y
    + furrowUnpack(furrowDirections[2].xy) * furrowWeights.z;
}

vec3 furrowShadingTangent() {
  return furrowUnpack(furrowDirections[0].zw) * furrowWeights.x
    + furrowUnpack(furrowDirections[1].zw) * furrowWeights.y
    + furrowUnpack(furrowDirections[2].zw) * furrowWeights.z;
}

/** Reads position and smooth normal of a vertex of the original mesh. Its smooth normal is the mean of the normals of all vertices at the position. */
void furrowReadParent(float first, float corner, vec2 direction, out vec3 position, out vec3 normal) {
  vec4 texel = furrowCoarse(furrowCoarsePositions, first);
  position = texel.xyz;
  if (first != corner) direction = furrowCoarse(furrowCoarseDirections, first).xy;
  normal = furrowUnpack(direction);
  if (texel.w == first) return;
  vec3 sum = normal;
  float next = texel.w;
  for (int i = 0; i < ${MAX_TWINS} && next != first; i++) {
    sum += furrowUnpack(furrowCoarse(furrowCoarseDirections, next).xy);
    next = furrowCoarse(furrowCoarsePositions, next).w;
  }
  normal = normalize(dot(sum, sum) > ${(CANCELLED ** 2).toExponential()} ? sum : normal);
}

float furrowDisplacement(vec2 at) {
  at = furrowRepeat(at);
  vec4 influence = furrowLookUp(at, ${isInstanced ? 'furrowCornerOf(float(gl_InstanceID))' : 'furrowCell.xy'});
  float height = 0.0;
  if (any(greaterThan(influence, vec4(0.0)))) height = 0.0 ${displacement.join(' ')};
  return height;
}

vec3 furrowSurface() {
  vec3 a, na;
  furrowReadParent(furrowParents.x, furrowCorners.x, furrowDirections[0].xy, a, na);
  vec3 b = a, nb = na, c = a, nc = na;
  vec3 w = furrowWeights;
  if (w.y > 0.0) furrowReadParent(furrowParents.y, furrowCorners.y, furrowDirections[1].xy, b, nb);
  if (w.z > 0.0) furrowReadParent(furrowParents.z, furrowCorners.z, furrowDirections[2].xy, c, nc);
  vec3 flatPoint = a * w.x + b * w.y + c * w.z;
  vec3 curve = dot(flatPoint - a, na) * na * w.x + dot(flatPoint - b, nb) * nb * w.y + dot(flatPoint - c, nc) * nc * w.z;
  float curved = ${PHONG.toFixed(2)} * furrowAmount * min(furrowClearance / ${CLEARANCE_TO_CURVE.toExponential()}, 1.0);
  float height = furrowDisplacement(furrowUvs.xy);
  if (furrowUvs.xy != furrowUvs.zw) height = (height + furrowDisplacement(furrowUvs.zw)) * 0.5;
  vec3 direction = normalize(na * w.x + nb * w.y + nc * w.z);
  float outwards = clamp(height, -furrowClearance, furrowClearance) * furrowAmount * furrowUnitsPerMetre;
  return flatPoint - curve * curved + direction * outwards;
}
`
}

/** Returns GLSL for the influence of a layer, after the delay by its onset map. */
function influenceOf(layer: number, onset: ReliefVariant['onset']): string {
  const slice = onset?.slices[layer] ?? null
  if (!onset || slice === null) return `influence[${layer}]`
  const level = `max(furrowLevel + ${onset.levels.toExponential()}, 0.0)`
  const value = `textureLod(furrow_${onset.sampler}, vec3(at, ${slice}.0), ${level})[${onset.channel}]`
  return `furrowOnsetInfluence(influence[${layer}], ${value}, furrowOnsetStrength[${layer}])`
}
