import {
  AddEquation,
  CustomBlending,
  MaxEquation,
  NoBlending,
  OneFactor,
  REVISION,
  ShaderMaterial,
  type WebGLRenderer,
} from 'three'
import type { QuadMaterials } from '../../atlas/quad-materials.ts'
import { requireInternal } from '../../three-version.ts'
import { QUAD_SETTINGS } from './quad-settings.ts'

/** Fragment shader that outputs the weight of an area times its activation, in the channel of the area's layer. */
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

/** Materials that draw influence maps with `WebGLRenderer`. */
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
    // After a context loss, three.js no longer has the properties of its textures.
    const properties = requireInternal(
      (renderer as WebGLRenderer).properties,
      WHO,
      'renderer.properties',
      REVISION,
    )
    const known = properties.get(target.texture) as { __webglTexture?: unknown }
    if (known.__webglTexture !== undefined) return true
    for (const _ in known)
      requireInternal(known.__webglTexture, WHO, '__webglTexture of a drawn render target', REVISION)
    return false
  },
}

const WHO = 'Wrinkles'
