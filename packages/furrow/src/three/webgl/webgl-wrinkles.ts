import type { Mesh, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { WrinkleTextures } from '../material/wrinkle-textures.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { composeMaterial } from './compose-material.ts'
import { influenceMaterial } from './influence-material.ts'
import { quadMaterials } from './influence-quads.ts'
import { defaultFragment, instancedVertex, paperFragment, type ShaderShape } from './shader.ts'
import { areaUniforms, layerUniforms, mapUniforms } from './uniforms.ts'

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a material of its own that is lit; each instance of an `InstancedMesh`
   *   or `BatchedMesh` wrinkles by itself.
   * @param source a set, copied: later changes to it are not seen, use `addArea` and `removeArea`. Or the wrinkles
   *   of another mesh, which are then shown here too, at rest, from the same textures.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super({ patch, influenceMaterial, composeMaterial, quads: quadMaterials }, mesh, source, options)
  }
}

/** A small patch of the material's own GLSL, chained after the user's `onBeforeCompile`, if any. */
const patch: RendererParts['patch'] = (material, inputs, mode, instances) => {
  const { onBeforeCompile, customProgramCacheKey } = material
  const own = { onBeforeCompile, customProgramCacheKey }
  const { paper, textures, areas } = inputs
  const { kinds, normals, values } = textures
  const anisotropic = normals.texture.anisotropy > 1
  const shape: ShaderShape = {
    kinds,
    normals: normals.slices,
    values: shapesOf(values),
    instances,
    anisotropic,
  }
  const inPaper = mode === 'paper' && paper
  const uniforms = inPaper
    ? { ...areaUniforms(inputs, inPaper.table), furrowColours: { value: inPaper.texture } }
    : { ...mapUniforms(inputs), ...layerUniforms(inputs) }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    Object.assign(shader.uniforms, uniforms)
    if (inPaper) {
      shader.fragmentShader = paperFragment(shader.fragmentShader, areas.channels, inPaper.diffuseIsSrgb)
      return
    }
    if (instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    shader.fragmentShader = defaultFragment(shader.fragmentShader, shape)
  }
  const variant = inPaper ? `paper ${areas.channels} ${inPaper.diffuseIsSrgb}` : JSON.stringify(shape)
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${variant}`
  return () => Object.assign(material, own)
}

function shapesOf(values: WrinkleTextures['values']): ShaderShape['values'] {
  return Object.fromEntries(
    Object.entries(values).map(([kind, { slices, channel }]) => [kind, { slices, channel }]),
  )
}
