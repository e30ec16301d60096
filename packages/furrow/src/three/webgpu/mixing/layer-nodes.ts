/** Nodes of the mode `default`, which mixes the maps of layers into the maps of the material before lighting. */
import type { Mesh } from 'three'
import { bitangentView, Fn, mat3, TBNViewMatrix, tangentView, varying, vec3 } from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { instancesOf } from '../../mesh/instances.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { negateOnBackSide } from '../newer-nodes.ts'
import { materialProperty, normalScale, typed } from '../node.ts'
import type { Added, Patched } from '../patch/patch-nodes.ts'
import { byGradients, bySampler, mapUv, repeat } from '../texture-sampling.ts'
import { addValues } from './add-values.ts'
import { type LayerInfluence, mixNormals, unpack } from './mix-normals.ts'
import { delayInfluence, texelReader } from './onset.ts'

/**
 * Creates nodes that mix the maps of layers into the maps of a material.
 *
 * @param mesh a mesh of the face.
 * @param isTiled whether texture coordinates may leave 0..1. They are then wrapped into 0..1.
 */
export function layerNodes(material: Patched, inputs: ShaderInputs, mesh: Mesh, isTiled: boolean): Added {
  const { normalNode: node } = material
  // A `normalNode` replaces the normal map of the material, so the layers are mixed into a flat normal, and the result is applied to the node.
  const base = node ? vec3(0, 0, 1) : unpack(materialProperty('normalMap', 'texture', material).xyz)
  const layers = layersOf(material, inputs, mesh, isTiled)
  const mixed = mixNormals(base, inputs, layers)
  const added: Added = {
    normalNode: node ? ontoNormal(typed(node), mixed, material) : inView(mixed, material),
  }
  addValues(added, material, inputs, { layers, ownNormal: base, mixed })
  return added
}

/** Returns the influence of a face's layers, after the delay by their onset maps, and the function that samples their maps. */
function layersOf(
  material: WrinkleMaterial,
  inputs: ShaderInputs,
  mesh: Mesh,
  isTiled: boolean,
): LayerInfluence {
  const uv = varying(mapUv(material))
  const within = isTiled ? repeat(uv).toVar() : uv
  const influence = influenceFromMap(inputs, within, instancesOf(mesh), false, inputs.isAlone())
  const maps = { uv, sampler: isTiled ? byGradients : bySampler, texels: new Map() }
  if (!inputs.textures.values.onset) return { influence, ...maps }
  return { influence: delayInfluence(inputs, influence, texelReader(maps)), ...maps }
}

/** Transforms a tangent-space normal to view space. three.js's `normalMap` does this only for normals that are encoded in 0..1. */
function inView(normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return Fn((_: [], builder: NodeBuilder) => {
    const scale = normalScale(material)
    const facing = (builder as FlatBuilder).isFlatShading() ? negateOnBackSide(typed(scale)) : scale
    return typed<'mat3'>(TBNViewMatrix)
      .mul(scaled(normal, typed(facing)))
      .normalize()
  })()
}

/** Builder with a method that is missing in three.js's declarations. */
type FlatBuilder = NodeBuilder & { isFlatShading(): boolean }

/** Applies a tangent-space normal to the view-space normal of a material's `normalNode`. */
function ontoNormal(viewNormal: Node<'vec3'>, normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), viewNormal)
    .mul(scaled(normal, normalScale(material)))
    .normalize()
}

function scaled(normal: Node<'vec3'>, scale: Node<'vec2'>): Node<'vec3'> {
  return vec3(normal.xy.mul(scale), normal.z)
}
