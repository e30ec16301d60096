/**
 * Shader that draws the influence maps of many faces into the cells of an atlas. For each texel and layer, it combines `weight * activation`
 * of the face's active areas by `sum` or `max`.
 *
 * The texture `furrowTable` contains the parameters. Row 0 has two texels per area. The first texel contains the bounds of the area. The second
 * texel contains the slice of the area, and the index of its layer (plus 4 if the area combines by `max`). Each other row belongs to one cell.
 * The first texel of the row contains the number of active areas, or -1 if the cell is not redrawn. Each following texel contains the index
 * and the activation of an active area.
 */

export const UNIFORMS = ['furrowSize']
export const SAMPLERS = ['furrowAreas', 'furrowTable']

export const GLSL = {
  vertex: /* glsl */ `
attribute vec2 position;
varying vec2 vUV;
void main(void) {
  vUV = position * 0.5 + 0.5;
  gl_Position = vec4(position, 0.0, 1.0);
}`,
  fragment: /* glsl */ `
precision highp float;
precision highp sampler2DArray;
varying vec2 vUV;
uniform sampler2DArray furrowAreas;
uniform highp sampler2D furrowTable;
uniform vec4 furrowSize;
void main(void) {
  ivec2 size = ivec2(furrowSize.xy);
  ivec2 texel = ivec2(vUV * furrowSize.xy * furrowSize.zw);
  ivec2 cell = texel / size;
  int row = 1 + cell.x + cell.y * int(furrowSize.z);
  texel -= cell * size;
  int count = int(texelFetch(furrowTable, ivec2(0, row), 0).x);
  if (count < 0) discard;
  vec4 sum = vec4(0.0);
  vec4 largest = vec4(0.0);
  for (int i = 1; i <= count; i++) {
    vec4 drawn = texelFetch(furrowTable, ivec2(i, row), 0);
    int area = 2 * int(drawn.x);
    ivec4 bounds = ivec4(texelFetch(furrowTable, ivec2(area, 0), 0));
    if (any(lessThan(texel, bounds.xy)) || any(greaterThanEqual(texel, bounds.zw))) continue;
    vec4 source = texelFetch(furrowTable, ivec2(area + 1, 0), 0);
    float influence = texelFetch(furrowAreas, ivec3(texel, int(source.x)), 0).r * drawn.y;
    int layer = int(source.y);
    vec4 added = vec4(equal(ivec4(layer & 3), ivec4(0, 1, 2, 3))) * influence;
    if (layer < 4) sum += added;
    else largest = max(largest, added);
  }
  gl_FragColor = max(sum, largest);
}`,
}

export const WGSL = {
  vertex: /* wgsl */ `
attribute position: vec2f;
varying vUV: vec2f;
@vertex
fn main(input: VertexInputs) -> FragmentInputs {
  vertexOutputs.vUV = vertexInputs.position * 0.5 + 0.5;
  vertexOutputs.position = vec4f(vertexInputs.position, 0.0, 1.0);
}`,
  fragment: /* wgsl */ `
varying vUV: vec2f;
var furrowAreas: texture_2d_array<f32>;
var furrowTable: texture_2d<f32>;
uniform furrowSize: vec4f;
@fragment
fn main(input: FragmentInputs) -> FragmentOutputs {
  let size = vec2i(uniforms.furrowSize.xy);
  let atlasTexel = vec2i(fragmentInputs.vUV * uniforms.furrowSize.xy * uniforms.furrowSize.zw);
  let cell = atlasTexel / size;
  let row = 1 + cell.x + cell.y * i32(uniforms.furrowSize.z);
  let texel = atlasTexel - cell * size;
  let count = i32(textureLoad(furrowTable, vec2i(0, row), 0).x);
  if (count < 0) { discard; }
  var sum = vec4f(0.0);
  var largest = vec4f(0.0);
  for (var i = 1; i <= count; i++) {
    let drawn = textureLoad(furrowTable, vec2i(i, row), 0);
    let area = 2 * i32(drawn.x);
    let bounds = vec4i(textureLoad(furrowTable, vec2i(area, 0), 0));
    if (any(texel < bounds.xy) || any(texel >= bounds.zw)) { continue; }
    let source = textureLoad(furrowTable, vec2i(area + 1, 0), 0);
    let influence = textureLoad(furrowAreas, texel, i32(source.x), 0).r * drawn.y;
    let layer = i32(source.y);
    let added = select(vec4f(0.0), vec4f(influence), vec4i(layer & 3) == vec4i(0, 1, 2, 3));
    if (layer < 4) { sum += added; } else { largest = max(largest, added); }
  }
  fragmentOutputs.color = max(sum, largest);
}`,
}
