import type { MeshStandardMaterial } from 'three'
import type { RendererParts } from '../../material/renderer-parts.ts'
import { isToon, type WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { tilingOf } from '../../mesh/tiling.ts'
import { layerNodes } from '../mixing/layer-nodes.ts'
import { patchNodes } from '../patch/patch-nodes.ts'

/** Default mode for `WebGPURenderer`. */
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

/** Bit mask of the material's maps that layers are mixed into, because nodes depend on them. */
function ownedMaps(material: WrinkleMaterial): number {
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  return (map ? 1 : 0) + (roughnessMap ? 2 : 0) + (aoMap ? 4 : 0)
}
