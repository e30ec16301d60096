/**
 * GLSL that samples the influence of all layers from the atlas, for any number of areas. The code has no branch, because a branch costs as
 * much as the texture sample that it would save. Call `furrowSampleInfluence` first in `main`: it sets globals for the other functions. The
 * globals `furrowDx` and `furrowDy` are only used if texture coordinates wrap.
 *
 * @param cell cell to sample.
 * @param isTiled whether texture coordinates leave 0..1, and so wrap.
 */
export function influenceFromMap(layers: number, cell: SampledCell, isTiled: boolean): string {
  // Missing channels are sampled as 0, but missing alpha as 1.
  const alpha = layers < 4 ? '0.0' : 'influence.a'
  return /* glsl */ `${cell === 'only' ? MAP : CELL}${isTiled ? REPEAT : ''}
${cell === 'instances' ? 'flat in highp vec2 vFurrowCorner;' : ''}
vec4 furrowInfluence = vec4(0.0);
vec2 furrowUv;
vec2 furrowDx;
vec2 furrowDy;

void furrowSampleInfluence(vec2 uv) {
  furrowUv = ${isTiled ? 'furrowRepeat(uv)' : 'uv'};
  furrowDx = dFdx(uv);
  furrowDy = dFdy(uv);
  vec4 influence = ${SAMPLE_CELL[cell]};
  furrowInfluence = vec4(influence.rgb, ${alpha});
}
`
}

/** Cell of the atlas that a shader samples: the mesh's, each instance's, or the only one. */
export type SampledCell = 'mesh' | 'instances' | 'only'

const SAMPLE_CELL: Record<SampledCell, string> = {
  mesh: 'furrowSampleCell(furrowUv, furrowCell.xy)',
  instances: 'furrowSampleCell(furrowUv, vFurrowCorner)',
  only: 'furrowSampleMap(furrowUv)',
}

/** Wraps texture coordinates into 0..1, see `repeat` in core. Coordinates within 0..1 stay bit-exact. */
export const REPEAT = /* glsl */ `
vec2 furrowRepeat(vec2 uv) {
  return uv - max(ceil(uv) - 1.0, min(floor(uv), 0.0));
}
`

/** Declares `vec4 furrowSampleMap(vec2 at)`: influence at a point of the atlas (0..1). */
const MAP = /* glsl */ `
uniform highp sampler2D furrowInfluenceMap;
uniform highp float furrowFade;

vec4 furrowSampleMap(vec2 at) {
  return min(textureLod(furrowInfluenceMap, at, 0.0), 1.0) * furrowFade;
}
`

/** Adds `vec4 furrowSampleCell(vec2 uv, vec2 corner)`: influence at texture coordinates (0..1) of the cell with this corner. */
const CELL = /* glsl */ `${MAP}
uniform highp vec4 furrowCell;
uniform highp vec4 furrowInside;

vec4 furrowSampleCell(vec2 uv, vec2 corner) {
  vec2 inside = clamp(uv * furrowInside.xy + furrowInside.zw, 0.0, 1.0);
  return furrowSampleMap(corner + inside * furrowCell.zw);
}
`

/** Adds `vec4 furrowLookUp(vec2 uv, vec2 corner)` for vertex shaders: skips the sample, and returns 0, outside the bounds of active areas. */
export const INFLUENCE_LOOKUP = /* glsl */ `${CELL}${REPEAT}
uniform highp vec4 furrowBounds;

vec4 furrowLookUp(vec2 uv, vec2 corner) {
  vec4 influence = vec4(0.0);
  if (all(greaterThanEqual(uv, furrowBounds.xy)) && all(lessThanEqual(uv, furrowBounds.zw))) {
    influence = furrowSampleCell(uv, corner);
  }
  return influence;
}
`

/**
 * Declares `vec2 furrowCornerOf(float instance)` for vertex shaders; instances have consecutive cells, row by row. Guarded, because the
 * default mode and relief may both declare it.
 */
export const CORNER_OF_INSTANCE = /* glsl */ `
#ifndef FURROW_CORNER
#define FURROW_CORNER
uniform highp vec3 furrowGrid;
uniform highp vec2 furrowInset;

vec2 furrowCornerOf(float instance) {
  float cell = furrowGrid.z + instance;
  float row = floor((cell + 0.5) / furrowGrid.x);
  return (vec2(cell - row * furrowGrid.x, row) + furrowInset) / furrowGrid.xy;
}
#endif
`

/**
 * Sampling of layer maps. `sampler` uses implicit derivatives and is cheapest. Wrapping coordinates need explicit ones: `gradients` for
 * anisotropic samplers, otherwise `level`, which is cheaper.
 */
export type SliceSampling = 'sampler' | 'gradients' | 'level'

/** Declares `vec4 furrowSampleSlice(highp sampler2DArray maps, float slice)`, which samples layer maps. */
export function sliceSampling(sampling: SliceSampling): string {
  return /* glsl */ `
vec4 furrowSampleSlice(highp sampler2DArray maps, float slice) {
  ${SAMPLE_SLICE[sampling]}
}
`
}

const BY_SAMPLER = 'return texture(maps, vec3(furrowUv, slice));'

const BY_GRADIENTS = 'return textureGrad(maps, vec3(furrowUv, slice), furrowDx, furrowDy);'

/** Level of detail by OpenGL ES 3.0, equations 3.18 and 3.21. */
const BY_LEVEL = /* glsl */ `vec2 size = vec2(textureSize(maps, 0).xy);
  vec2 dx = furrowDx * size;
  vec2 dy = furrowDy * size;
  return textureLod(maps, vec3(furrowUv, slice), 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)));`

const SAMPLE_SLICE: Record<SliceSampling, string> = {
  sampler: BY_SAMPLER,
  gradients: BY_GRADIENTS,
  level: BY_LEVEL,
}
