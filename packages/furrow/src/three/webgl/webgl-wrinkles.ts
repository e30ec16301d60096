import type { Mesh, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { WrinkleTextures } from '../material/wrinkle-textures.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { composeMaterial } from './compose-material.ts'
import { defaultFragment, instancedVertex, type ShaderVariant } from './default-shader.ts'
import { influenceMaterial } from './influence-material.ts'
import { quadMaterials } from './influence-quads.ts'
import { paperFragment } from './paper-shader.ts'
import { areaUniforms, layerUniforms, mapUniforms } from './uniforms.ts'

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a lit material of its own; each instance of an `InstancedMesh`
   *   or `BatchedMesh` wrinkles independently.
   * @param source a set, copied: later changes to it have no effect, use `addArea` and `removeArea`. Or the wrinkles
   *   of another mesh, which are then shown here too, at rest, from the same textures.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super({ patch, influenceMaterial, composeMaterial, quads: quadMaterials }, mesh, source, options)
  }
}

/** Patches the material's own GLSL, after the user's `onBeforeCompile`, if any. */
const patch: RendererParts['patch'] = (material, inputs, mode, instances) => {
  const { onBeforeCompile, customProgramCacheKey } = material
  const original = { onBeforeCompile, customProgramCacheKey }
  const { textures, areas } = inputs
  const paper = mode === 'paper' ? inputs.paper : null
  const variant: ShaderVariant = {
    kinds: textures.kinds,
    normals: textures.normals.slices,
    values: valueLayers(textures.values),
    instances,
    anisotropic: textures.normals.texture.anisotropy > 1,
  }
  const uniforms = paper
    ? { ...areaUniforms(inputs, paper.table), furrowColours: { value: paper.texture } }
    : { ...mapUniforms(inputs), ...layerUniforms(inputs) }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    Object.assign(shader.uniforms, uniforms)
    if (paper) {
      shader.fragmentShader = paperFragment(shader.fragmentShader, areas.channels, paper.diffuseIsSrgb)
      return
    }
    if (instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    shader.fragmentShader = defaultFragment(shader.fragmentShader, variant)
  }
  const key = paper ? `paper ${areas.channels} ${paper.diffuseIsSrgb}` : JSON.stringify(variant)
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${key}`
  return () => Object.assign(material, original)
}

function valueLayers(values: WrinkleTextures['values']): ShaderVariant['values'] {
  return Object.fromEntries(
    Object.entries(values).map(([kind, { slices, channel }]) => [kind, { slices, channel }]),
  )
}
