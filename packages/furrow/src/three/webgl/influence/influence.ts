/**
 * The influence of each layer: one sample of the atlas of influence maps, however many areas there are. No branch between pixels: graphics cards
 * and software rasterisers pay as much for one as for the sample that it saves. `furrowSampleInfluence` is called first in `main`; the other
 * functions read the globals that it sets, `furrowDx` and `furrowDy` only where coordinates wrap.
 *
 * @param cell which one: that of the mesh, of each of its instances, or the only one that there is.
 * @param isTiled whether texture coordinates leave 0..1, and so wrap.
 */
export function influenceFromMap(layers: number, cell: SampledCell, isTiled: boolean): string {
  // What the texture lacks is 0 in a sample, but alpha is 1.
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

/** The cell of the atlas that a shader samples. */
export type SampledCell = 'mesh' | 'instances' | 'only'

const SAMPLE_CELL: Record<SampledCell, string> = {
  mesh: 'furrowSampleCell(furrowUv, furrowCell.xy)',
  instances: 'furrowSampleCell(furrowUv, vFurrowCorner)',
  only: 'furrowSampleMap(furrowUv)',
}

/** Wraps texture coordinates into 0..1, see `repeat` in core; those already within stay exactly as they are. */
export const REPEAT = /* glsl */ `
vec2 furrowRepeat(vec2 uv) {
  return uv - max(ceil(uv) - 1.0, min(floor(uv), 0.0));
}
`

/** Declares `vec4 furrowSampleMap(vec2 at)`: the influence at a point of the atlas, 0..1. */
const MAP = /* glsl */ `
uniform highp sampler2D furrowInfluenceMap;
uniform highp float furrowFade;

vec4 furrowSampleMap(vec2 at) {
  return min(textureLod(furrowInfluenceMap, at, 0.0), 1.0) * furrowFade;
}
`

/** Declares `vec4 furrowSampleCell(vec2 uv, vec2 corner)` besides: the influence of the cell at a corner, at texture coordinates within 0..1. */
const CELL = /* glsl */ `${MAP}
uniform highp vec4 furrowCell;
uniform highp vec4 furrowInside;

vec4 furrowSampleCell(vec2 uv, vec2 corner) {
  vec2 inside = clamp(uv * furrowInside.xy + furrowInside.zw, 0.0, 1.0);
  return furrowSampleMap(corner + inside * furrowCell.zw);
}
`

/** Declares `vec4 furrowLookUp(vec2 uv, vec2 corner)` besides: the same, 0 outside of what active areas reach. For vertices, which skip the sample there. */
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
 * Declares `vec2 furrowCornerOf(float instance)`, for vertex shaders; each instance has a cell, in the order of rows. A shader may have it
 * twice, by the default mode and by relief.
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
 * How the layers' maps are sampled: the sampler finds the level of detail, which costs least; where coordinates wrap, with their gradients,
 * which samplers with anisotropy need, or at the level of detail computed from them, which costs less.
 */
export type SliceSampling = 'sampler' | 'gradients' | 'level'

/** Declares `vec4 furrowSampleSlice(highp sampler2DArray maps, float slice)`, which samples the layers' maps. */
export function sliceSampling(sampling: SliceSampling): string {
  return /* glsl */ `
vec4 furrowSampleSlice(highp sampler2DArray maps, float slice) {
  ${SAMPLE_SLICE[sampling]}
}
`
}

const BY_SAMPLER = 'return texture(maps, vec3(furrowUv, slice));'

const BY_GRADIENTS = 'return textureGrad(maps, vec3(furrowUv, slice), furrowDx, furrowDy);'

/** The level of detail of OpenGL ES 3.0, equations 3.18 and 3.21. */
const BY_LEVEL = /* glsl */ `vec2 size = vec2(textureSize(maps, 0).xy);
  vec2 dx = furrowDx * size;
  vec2 dy = furrowDy * size;
  return textureLod(maps, vec3(furrowUv, slice), 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)));`

const SAMPLE_SLICE: Record<SliceSampling, string> = {
  sampler: BY_SAMPLER,
  gradients: BY_GRADIENTS,
  level: BY_LEVEL,
}
