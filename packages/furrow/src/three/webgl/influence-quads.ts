import {
  AddEquation,
  CustomBlending,
  DoubleSide,
  GLSL3,
  MaxEquation,
  NoBlending,
  OneFactor,
  ShaderMaterial,
  type WebGLRenderer,
} from 'three'
import type { QuadMaterials } from '../atlas/influence-pass.ts'
import { requireInternal } from '../three-version.ts'

/** Draws `Quads`: `targetUv` is the point of the target, 0..1, `texel` that of the area. */
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

/** The area's weight at the texel, times its activation in the channel of its layer. */
const FRAGMENT = /* glsl */ `
uniform highp sampler2DArray areas;
in vec2 texel;
flat in ivec2 source;
flat in vec4 activation;
out vec4 influence;

void main() {
  influence = texelFetch(areas, ivec3(ivec2(texel), source.x), 0)[source.y] * activation;
}
`

const CLEAR = /* glsl */ `
out vec4 influence;

void main() {
  influence = vec4(0.0);
}
`

/** What all materials of `Quads` have in common. */
export const QUAD_SETTINGS = {
  glslVersion: GLSL3,
  vertexShader: VERTEX,
  blending: NoBlending,
  side: DoubleSide,
  depthTest: false,
  depthWrite: false,
} as const

/** The materials that draw influence maps on `WebGLRenderer`. */
export const quadMaterials: QuadMaterials = {
  create(rule, areas) {
    return new ShaderMaterial({
      ...QUAD_SETTINGS,
      name: `furrow ${rule}`,
      fragmentShader: areas ? FRAGMENT : CLEAR,
      uniforms: areas ? { areas: { value: areas.texture } } : {},
      blending: rule === 'clear' ? NoBlending : CustomBlending,
      blendEquation: rule === 'max' ? MaxEquation : AddEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
      transparent: true,
    })
  },
  hasContents(renderer, target) {
    // A context that was lost and restored has none of its textures, nor anything known of them.
    const properties = requireInternal((renderer as WebGLRenderer).properties, WHO, 'renderer.properties')
    const known = properties.get(target.texture) as { __webglTexture?: unknown }
    if (known.__webglTexture !== undefined) return true
    for (const _ in known)
      requireInternal(known.__webglTexture, WHO, '__webglTexture of a drawn render target')
    return false
  },
}

/** Who an error names. */
const WHO = 'Wrinkles'
