/** The nodes of the default mode: the layers' maps mixed into the material's, lit once. */
import type { Mesh } from 'three'
import { bitangentView, mat3, normalMap, tangentView, varying, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { Patch } from '../../material/patch.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { instancesOf } from '../../mesh/instances.ts'
import { isTiled } from '../../mesh/wrinkle-uvs.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { materialProperty, normalScale, typed } from '../node.ts'
import type { Added, Patched } from '../patch/patch-nodes.ts'
import { byGradients, bySampler, mapUv, repeat } from '../texture-sampling.ts'
import type { NodeChannels } from './channels.ts'
import { type LayerInfluence, mixNormals } from './mix-normals.ts'

/** The influence of a face's layers, and how their maps are sampled. */
export function layersOf(
  material: WrinkleMaterial,
  inputs: ShaderInputs,
  meshes: readonly Mesh[],
): LayerInfluence {
  const uv = varying(mapUv(material))
  // One variable for all samples.
  const wrapped = repeat(uv).toVar()
  return {
    influence: influenceFromMap(inputs, wrapped, instancesOf(meshes[0])),
    ...(haveTiles(meshes, material) ? { uv, sampler: byGradients } : { uv: wrapped, sampler: bySampler }),
  }
}

/** Whether texture coordinates wrap within any of the meshes. */
export function haveTiles(meshes: readonly Mesh[], material: WrinkleMaterial): boolean {
  return meshes.some((mesh) => isTiled(mesh, material))
}

/** What a material's own maps hold. */
export interface OwnTexels {
  /** The normal as stored, 0..1; flat for one whose normals are those of a node. */
  stored: Node<'vec3'>
  /** That node. */
  node?: Node | null | undefined
  /** That of its map of occlusion; the default mode's samples the map. */
  occlusion?: Node<'float'>
}

/** A material in the default mode. What is fetched for it mixes by this: modules that it would share with the page would come in files of their own. */
export interface NodePatch extends Patch {
  /** The nodes of the default mode with other texels of the material's own, and of its layers. */
  mix(own: OwnTexels, change?: (layers: LayerInfluence) => LayerInfluence): Added
}

/** Those of a material before it is patched. */
export function ownTexelsOf(material: Patched): OwnTexels {
  const { normalNode: node } = material
  return {
    stored: node ? vec3(0.5, 0.5, 1) : materialProperty('normalMap', 'texture', material).xyz,
    node,
  }
}

/**
 * Mixes the layers' maps into a material's own.
 *
 * @param channels mix the other maps; null where there are none.
 */
export function layerNodes(
  material: Patched,
  inputs: ShaderInputs,
  layers: LayerInfluence,
  { stored, node, occlusion }: OwnTexels,
  channels: NodeChannels | null,
): Added {
  const mixed = mixNormals(stored, inputs, layers)
  const added: Added = {
    normalNode: node ? ontoNormal(typed(node), mixed, material) : normalMap(mixed, normalScale(material)),
  }
  channels?.add(added, material, inputs, { layers, ownNormal: stored, mixed, ownOcclusion: occlusion })
  return added
}

/** Lays stored normals onto a material's own, in view space, that are not those of a map. */
function ontoNormal(own: Node<'vec3'>, stored: Node<'vec3'>, material: Patched): Node<'vec3'> {
  const normal = stored.mul(2).sub(1).toVar()
  const scaled = vec3(normal.xy.mul(normalScale(material)), normal.z)
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), own).mul(scaled).normalize()
}
