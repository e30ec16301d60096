import { type Material, type MeshStandardMaterial, ShaderMaterial, type Texture } from 'three'
import { texture, varying, vec4 } from 'three/tsl'
import { createAreaArray } from '../../../packages/furrow/src/three/atlas/area-array.ts'
import { ComposedMap, composedSize } from '../../../packages/furrow/src/three/material/composed-map.ts'
import { callBeforeRender } from '../../../packages/furrow/src/three/mesh/before-render.ts'
import { WRINKLES_DEFAULTS } from '../../../packages/furrow/src/three/options.ts'
import { quadMaterials as glslQuads } from '../../../packages/furrow/src/three/webgl/influence/influence-quads.ts'
import { QUAD_SETTINGS } from '../../../packages/furrow/src/three/webgl/influence/quad-settings.ts'
import {
  quadMaterial,
  targetUv,
  quadMaterials as tslQuads,
} from '../../../packages/furrow/src/three/webgpu/influence/influence-quads.ts'
import { texelAt } from '../../../packages/furrow/src/three/webgpu/modes/compose-material.ts'
import type { RendererKind } from '../../../stage/stage.ts'
import type { Variant } from '../variant.ts'

/**
 * Lower bound for the cost of the composed mode. Each frame, it copies texels from the face's normal map to a second texture: the texels that the
 * composed mode would redraw. It computes no influence map and mixes no normals, so the picture equals the face without wrinkles.
 */
export const variant: Variant = {
  canShow: ({ still, layers, maps }) => !still && layers === 1 && maps === 'normals',
  sameAs: 'plain',
  apply: (mesh, set, renderer) => {
    const material = mesh.material as MeshStandardMaterial
    const base = material.normalMap!
    const { hasContents } = renderer === 'webgl' ? glslQuads : tslQuads
    const map = new ComposedMap(base, composedSize(base, base), copyMaterial(base, renderer), hasContents)
    const areas = createAreaArray(set.areas, set.layers, WRINKLES_DEFAULTS.areaSize, 'bench')
    const indices = new Map(set.areas.map(({ name }, i) => [name, i]))
    const values = new Float32Array(set.areas.length)
    material.normalMap = map.target.texture
    callBeforeRender(mesh, (used) => map.update(used, areas, values, 1, 0))
    return {
      setActivation(area, value) {
        values[indices.get(area)!] = value
      },
      dispose() {
        map.dispose()
        areas.texture.dispose()
      },
    }
  },
}

function copyMaterial(base: Texture, renderer: RendererKind): Material {
  if (renderer === 'webgl') {
    return new ShaderMaterial({
      ...QUAD_SETTINGS,
      fragmentShader: GLSL,
      uniforms: { base: { value: base } },
    })
  }
  const source = texture(base)
  return quadMaterial('copied', vec4(source.load(texelAt(source, varying(targetUv()))).xyz, 1))
}

const GLSL = /* glsl */ `
uniform sampler2D base;
out vec4 copied;

void main() {
  copied = texelFetch(base, ivec2(gl_FragCoord.xy), 0);
}`
