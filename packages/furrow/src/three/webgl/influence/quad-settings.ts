import { DoubleSide, GLSL3, NoBlending } from 'three'

/**
 * Vertex shader of `Quads`. `targetUv` is the position in the render target (0..1), and `texel` the position in the area's image (texels).
 * `source` holds the slice and channel of the area. `activation` has the activation in the component of the area's layer, and 0 in the others.
 */
const VERTEX = /* glsl */ `
in vec4 furrowPoint;
in vec2 furrowSource;
out vec2 texel;
out vec2 targetUv;
flat out ivec2 source;
flat out vec4 activation;

void main() {
  texel = furrowPoint.zw;
  int packed = int(furrowSource.y);
  source = ivec2(packed >> 4, (packed >> 2) & 3);
  activation = furrowSource.x * vec4(equal(ivec4(packed & 3), ivec4(0, 1, 2, 3)));
  targetUv = furrowPoint.xy;
  gl_Position = vec4(targetUv * 2.0 - 1.0, 0.0, 1.0);
}
`

/** Settings of all materials of `Quads`. */
export const QUAD_SETTINGS = {
  glslVersion: GLSL3,
  vertexShader: VERTEX,
  blending: NoBlending,
  side: DoubleSide,
  depthTest: false,
  depthWrite: false,
} as const
