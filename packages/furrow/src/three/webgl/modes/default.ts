import type { RendererParts } from '../../material/renderer-parts.ts'
import { isToon } from '../../material/wrinkle-material.ts'
import { instancesOf } from '../../mesh/instances.ts'
import { tilingOf } from '../../mesh/tiling.ts'
import type { SliceSampling } from '../influence/influence.ts'
import { defaultFragment, instancedVertex, type ShaderVariant } from '../mixing/default-shader.ts'
import { valueLayers } from '../mixing/value-layers.ts'
import { patchShader, type ShaderEdit } from '../patch/patch-shader.ts'
import { layerUniforms, mapUniforms } from '../uniforms.ts'

/** Patches a material for the mode `default` of `WebGLRenderer`: mixes the maps of layers into the maps of the material before lighting. */
export const showDefault: RendererParts['showDefault'] = ({
  material,
  inputs,
  meshes,
  refuse,
  onCompile,
}) => {
  const { textures } = inputs
  const instances = instancesOf(meshes[0])
  const { isTiled, supportsMesh, isCurrent: isTilingCurrent } = tilingOf(meshes, material)
  const isAlone = inputs.isAlone()
  const cell = isAlone ? 'only' : 'mesh'
  const variant: ShaderVariant = {
    kinds: textures.kinds,
    normals: textures.normals.slices,
    values: valueLayers(textures.values),
    cell: instances ? 'instances' : cell,
    isTiled,
    sampling: samplingOf(isTiled, textures.normals.texture.anisotropy),
    isToon: isToon(material),
  }
  const edit: ShaderEdit = {
    key: JSON.stringify({ ...variant, instances }),
    uniforms: { ...mapUniforms(inputs), ...layerUniforms(inputs) },
    apply(shader) {
      shader.fragmentShader = defaultFragment(shader.fragmentShader, variant)
      if (instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    },
    refuse,
  }
  const isCurrent = () => isTilingCurrent() && (!isAlone || inputs.isAlone())
  return { ...patchShader(material, edit, onCompile), supportsMesh, isCurrent }
}

function samplingOf(isTiled: boolean, anisotropy: number): SliceSampling {
  if (!isTiled) return 'sampler'
  return anisotropy > 1 ? 'gradients' : 'level'
}
