/**
 * How much of each layer shows: one sample of the atlas of influence maps. `furrowBegin` is called first in `main`;
 * what it leaves is read by all the rest. Maps of layers are sampled by gradients taken here, since they are sampled
 * inside branches, where neighbouring pixels part ways.
 *
 * @param isAnisotropic whether the maps' samplers are: only then are the gradients themselves needed, which cost more than the
 *   level they come to.
 */
export function influenceFromMap(layers: number, isInstanced: boolean, isAnisotropic: boolean): string {
  const channels = Array.from({ length: 4 }, (_, i) => (i < layers ? `shares[${i}]` : '0.0'))
  return /* glsl */ `${REPEAT}
uniform highp sampler2D furrowInfluence;
uniform vec3 furrowGrid;
uniform vec2 furrowInset;
uniform vec4 furrowReach;
uniform float furrowFade;
${isInstanced ? 'flat in float vFurrowInstance;' : 'const float vFurrowInstance = 0.0;'}
vec4 furrowShares = vec4(0.0);
bool furrowShows = false;
vec2 furrowUv;
vec2 furrowDx;
vec2 furrowDy;

void furrowBegin(vec2 place) {
  vec2 uv = furrowRepeat(place);
  furrowUv = uv;
  furrowDx = dFdx(place);
  furrowDy = dFdy(place);
  if (furrowFade <= 0.0 || any(lessThan(uv, furrowReach.xy)) || any(greaterThan(uv, furrowReach.zw))) return;
  float index = furrowGrid.z + vFurrowInstance;
  float row = floor((index + 0.5) / furrowGrid.x);
  vec2 corner = vec2(index - row * furrowGrid.x, row);
  vec2 inside = clamp(uv, furrowInset, 1.0 - furrowInset);
  vec4 shares = min(textureLod(furrowInfluence, (corner + inside) / furrowGrid.xy, 0.0), 1.0) * furrowFade;
  furrowShares = vec4(${channels.join(', ')});
  furrowShows = any(greaterThan(furrowShares, vec4(0.0)));
}

vec4 furrowMap(highp sampler2DArray maps, float slice) {
  ${isAnisotropic ? GRADIENTS : LEVEL}
}
`
}

/** Texture coordinates outside 0..1 less their whole numbers, see `repeat` in core; those within are left exactly as they are. */
const REPEAT = /* glsl */ `
vec2 furrowRepeat(vec2 uv) {
  return uv - max(ceil(uv) - 1.0, min(floor(uv), 0.0));
}
`

const GRADIENTS = 'return textureGrad(maps, vec3(furrowUv, slice), furrowDx, furrowDy);'

/** The level of OpenGL ES 3.0, equations 3.18 and 3.21. */
const LEVEL = /* glsl */ `vec2 size = vec2(textureSize(maps, 0).xy);
  vec2 dx = furrowDx * size;
  vec2 dy = furrowDy * size;
  return textureLod(maps, vec3(furrowUv, slice), 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)));`

/** The same from the areas themselves, as in the paper's step 3: a loop over all of them, for every layer at once. */
export function influenceFromAreas(channels: 1 | 4): string {
  const weight = channels === 1 ? 'texel.r' : 'texel[i % 4]'
  const slice = channels === 1 ? 'i' : 'i / 4'
  return /* glsl */ `${REPEAT}
uniform highp sampler2DArray furrowAreas;
uniform highp sampler2D furrowActivations;
uniform int furrowAreaCount;

vec4 furrowSum(vec2 place) {
  vec2 uv = furrowRepeat(place);
  vec4 added = vec4(0.0);
  vec4 largest = vec4(0.0);
  for (int i = 0; i < furrowAreaCount; i++) {
    vec4 texel = textureLod(furrowAreas, vec3(uv, float(${slice})), 0.0);
    float weight = ${weight};
    added += weight * texelFetch(furrowActivations, ivec2(i, 0), 0);
    largest = max(largest, weight * texelFetch(furrowActivations, ivec2(i, 1), 0));
  }
  return max(min(added, 1.0), largest);
}
`
}
