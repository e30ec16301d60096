/**
 * Returns GLSL that samples the influence map of a face. The map holds, per layer, how strongly the layer is visible. Maps of several faces
 * are cells of one texture, the influence atlas. `main` must call `furrowSampleInfluence` first, because that function sets globals for other
 * functions. The code has no branch, because a branch costs as much as the texture sample that it would save.
 *
 * @param isTiled whether texture coordinates may leave 0..1. They are then wrapped into 0..1.
 */
export function influenceFromMap(layers: number, cell: SampledCell, isTiled: boolean): string {
  // Textures with fewer than four channels return 0 for missing colour channels, but 1 for alpha.
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

/** Cell that a shader samples: the cell of the mesh, the cell of the drawn instance, or the only cell, which fills the atlas. */
export type SampledCell = 'mesh' | 'instances' | 'only'

const SAMPLE_CELL: Record<SampledCell, string> = {
  mesh: 'furrowSampleCell(furrowUv, furrowCell.xy)',
  instances: 'furrowSampleCell(furrowUv, vFurrowCorner)',
  only: 'furrowSampleMap(furrowUv)',
}

/** Declares `furrowRepeat`, which wraps texture coordinates into 0..1, see `repeat` in core. Coordinates within 0..1 stay bit-identical. */
export const REPEAT = /* glsl */ `
vec2 furrowRepeat(vec2 uv) {
  return uv - max(ceil(uv) - 1.0, min(floor(uv), 0.0));
}
`

/** Declares `vec4 furrowSampleMap(vec2 at)`, which returns the influence at a point of the atlas (0..1). */
const MAP = /* glsl */ `
uniform highp sampler2D furrowInfluenceMap;
uniform highp float furrowFade;

vec4 furrowSampleMap(vec2 at) {
  return min(textureLod(furrowInfluenceMap, at, 0.0), 1.0) * furrowFade;
}
`

/**
 * Adds `vec4 furrowSampleCell(vec2 uv, vec2 corner)`, which returns the influence at texture coordinates (0..1) in a cell. `corner` is the
 * centre of the first texel of the cell.
 */
const CELL = /* glsl */ `${MAP}
uniform highp vec4 furrowCell;
uniform highp vec4 furrowInside;

vec4 furrowSampleCell(vec2 uv, vec2 corner) {
  vec2 inside = clamp(uv * furrowInside.xy + furrowInside.zw, 0.0, 1.0);
  return furrowSampleMap(corner + inside * furrowCell.zw);
}
`

/**
 * Adds `vec4 furrowLookUp(vec2 uv, vec2 corner)` for vertex shaders. It returns the same as `furrowSampleCell`, but outside the bounds of
 * active areas it returns 0 without a texture sample.
 */
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
 * Declares `vec2 furrowCornerOf(float instance)` for vertex shaders. It returns the centre of the first texel of an instance's cell, in atlas
 * coordinates (0..1). Instances have consecutive cells, row by row. The `#ifndef` is needed because the default mode and relief may both add
 * this code to one shader.
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
 * Method that chooses the mipmap level when layer maps are sampled. `sampler` leaves the choice to the GPU, and is cheapest. Wrapped texture
 * coordinates jump between neighbouring pixels, so their derivatives must be taken before wrapping. `gradients` passes these derivatives to
 * the GPU; anisotropic filtering needs them. `level` computes the mipmap level from them, which is cheaper.
 */
export type SliceSampling = 'sampler' | 'gradients' | 'level'

/** Declares a function `vec4 (highp sampler2DArray maps, float slice)`, which samples a layer map. */
export function sliceSampling(sampling: SliceSampling, name = 'furrowSampleSlice'): string {
  return /* glsl */ `
vec4 ${name}(highp sampler2DArray maps, float slice) {
  ${SAMPLE_SLICE[sampling]}
}
`
}

const BY_SAMPLER = 'return texture(maps, vec3(furrowUv, slice));'

const BY_GRADIENTS = 'return textureGrad(maps, vec3(furrowUv, slice), furrowDx, furrowDy);'

/** Computes the mipmap level by equations 3.18 and 3.21 of OpenGL ES 3.0. */
const BY_LEVEL = /* glsl */ `vec2 size = vec2(textureSize(maps, 0).xy);
  vec2 dx = furrowDx * size;
  vec2 dy = furrowDy * size;
  return textureLod(maps, vec3(furrowUv, slice), 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)));`

const SAMPLE_SLICE: Record<SliceSampling, string> = {
  sampler: BY_SAMPLER,
  gradients: BY_GRADIENTS,
  level: BY_LEVEL,
}
