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

/** Of all that draws `Quads`: `place` is the point of the target, 0..1, `texel` that of the area. */
const VERTEX = /* glsl */ `
in vec4 furrowTo;
in vec4 furrowFrom;
in vec4 furrowAt;
in vec4 furrowShare;
out vec2 texel;
out vec2 place;
flat out ivec2 at;
flat out vec4 share;

void main() {
  texel = mix(furrowFrom.xy, furrowFrom.zw, position.xy);
  at = ivec2(furrowAt.xy);
  share = furrowShare;
  place = mix(furrowTo.xy, furrowTo.zw, position.xy);
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
`

const FRAGMENT = /* glsl */ `
uniform highp sampler2DArray areas;
in vec2 texel;
flat in ivec2 at;
flat in vec4 share;
out vec4 influence;

void main() {
  influence = texelFetch(areas, ivec3(ivec2(texel), at.x), 0)[at.y] * share;
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
    // A context that was lost and came back has none of its textures.
    const { properties } = renderer as WebGLRenderer
    const held = properties.get(target.texture) as { __webglTexture?: unknown }
    return held.__webglTexture !== undefined
  },
}
