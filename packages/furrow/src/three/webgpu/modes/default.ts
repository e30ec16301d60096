import type { MeshStandardMaterial } from 'three'
import type { RendererParts } from '../../material/renderer-parts.ts'
import { isToon, type WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { tilingOf } from '../../mesh/tiling.ts'
import { layerNodes } from '../mixing/layer-nodes.ts'
import { patchNodes } from '../patch/patch-nodes.ts'

/** Patches a material for the mode `default` of `WebGPURenderer`: mixes the maps of layers into the maps of the material before lighting. */
export const showDefault: RendererParts['showDefault'] = ({ material, inputs, meshes }) => {
  const { isTiled, supportsMesh, isCurrent: isTilingCurrent } = tilingOf(meshes, material)
  const mixesMaps = isToon(material) || Object.keys(inputs.textures.values).length > 0
  const owned = ownedMaps(material)
  const isAlone = inputs.isAlone()
  const isCurrent = () =>
    isTilingCurrent() && (!isAlone || inputs.isAlone()) && (!mixesMaps || ownedMaps(material) === owned)
  return {
    ...patchNodes(material, layerNodes(material, inputs, meshes[0], isTiled)),
    supportsMesh,
    isCurrent,
  }
}

/** Returns a bit mask of the maps that a material has. The nodes must be rebuilt when it changes. */
function ownedMaps(material: WrinkleMaterial): number {
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  return (map ? 1 : 0) + (roughnessMap ? 2 : 0) + (aoMap ? 4 : 0)
}
