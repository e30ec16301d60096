import type { Mesh, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import { isToon } from '../material/wrinkle-material.ts'
import type { ValueKind, WrinkleTextures } from '../material/wrinkle-textures.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { composeMaterial } from './compose-material.ts'
import { defaultFragment, instancedVertex, isPatchable, type ShaderVariant } from './default-shader.ts'
import { influenceMaterial } from './influence-material.ts'
import { quadMaterials } from './influence-quads.ts'
import { paperFragment } from './paper-shader.ts'
import { faultOf } from './program-fault.ts'
import { areaUniforms, layerUniforms, mapUniforms } from './uniforms.ts'

/** The wrinkles of a loaded file, whose drivers the loader adds; `Wrinkles` is the same for all else. */
export class WebGLWrinkles extends WrinklesBase {
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(PARTS, mesh, source, options)
  }
}

/** Patches the material's own GLSL, after the user's `onBeforeCompile`, if any. */
const patch: RendererParts['patch'] = (material, inputs, mode, instances, refuse) => {
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
    isToon: isToon(material),
  }
  const uniforms = paper
    ? { ...areaUniforms(inputs, paper.table), furrowColours: { value: paper.texture } }
    : { ...mapUniforms(inputs), ...layerUniforms(inputs) }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    try {
      const { fragmentShader } = shader
      shader.fragmentShader = paper
        ? paperFragment(fragmentShader, areas.channels, paper.diffuseIsSrgb)
        : defaultFragment(fragmentShader, variant)
    } catch {
      return refuse()
    }
    if (instances && !paper) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    // Not into the object itself: a ShaderMaterial's is its own, which its copies copy.
    shader.uniforms = { ...shader.uniforms, ...uniforms }
  }
  const key = paper ? `paper ${areas.channels} ${paper.diffuseIsSrgb}` : JSON.stringify(variant)
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${key}`
  return () => Object.assign(material, original)
}

/**
 * three.js keeps the programs of a material, but the uniforms of the one that it built last: a program that it takes up again, as that of the
 * default mode after `off`, would get none of its own.
 */
const renew: RendererParts['renew'] = (material) => {
  material.dispose()
  material.needsUpdate = true
}

const PARTS: RendererParts = {
  entry: 'furrow/three',
  canPatch: ({ fragmentShader, isRawShaderMaterial }) =>
    fragmentShader === undefined || (!isRawShaderMaterial && isPatchable(fragmentShader)),
  patch,
  renew,
  faultOf,
  composeMaterial,
  influenceMaterial,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief.ts')).RELIEF_PARTS,
}

function valueLayers(values: WrinkleTextures['values']): ShaderVariant['values'] {
  const kinds = Object.keys(values) as ValueKind[]
  return Object.fromEntries(
    Object.entries(values).map(([kind, { texture, slices, channel }]) => {
      const sampler = kinds.find((other) => values[other]!.texture === texture)!
      return [kind, { slices, channel, sampler }]
    }),
  )
}
