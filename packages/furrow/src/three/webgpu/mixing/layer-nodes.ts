/** Nodes of the default mode: mixes the layers' maps into the material's, and lights once. */
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

/**
 * Creates nodes that mix the layers' maps into a material's own.
 *
 * @param mesh a mesh of the face.
 * @param isTiled whether texture coordinates leave 0..1, and so wrap.
 */
export function layerNodes(material: Patched, inputs: ShaderInputs, mesh: Mesh, isTiled: boolean): Added {
  const { normalNode: node } = material
  // Materials with a `normalNode` have a flat normal map.
  const base = node ? vec3(0, 0, 1) : unpack(materialProperty('normalMap', 'texture', material).xyz)
  const layers = layersOf(material, inputs, mesh, isTiled)
  const mixed = mixNormals(base, inputs, layers)
  const added: Added = {
    normalNode: node ? ontoNormal(typed(node), mixed, material) : inView(mixed, material),
  }
  addValues(added, material, inputs, { layers, ownNormal: base, mixed })
  return added
}

/** Influence of a face's layers, and the sampling of their maps. */
function layersOf(
  material: WrinkleMaterial,
  inputs: ShaderInputs,
  mesh: Mesh,
  isTiled: boolean,
): LayerInfluence {
  const uv = varying(mapUv(material))
  const within = isTiled ? repeat(uv).toVar() : uv
  return {
    influence: influenceFromMap(inputs, within, instancesOf(mesh), false, inputs.isAlone()),
    uv,
    sampler: isTiled ? byGradients : bySampler,
  }
}

/** Transforms a tangent-space normal to view space, like three.js's `normalMap`, which accepts packed normals only. */
function inView(normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return Fn((_: [], builder: NodeBuilder) => {
    const scale = normalScale(material)
    const facing = (builder as FlatBuilder).isFlatShading() ? negateOnBackSide(typed(scale)) : scale
    return typed<'mat3'>(TBNViewMatrix)
      .mul(scaled(normal, typed(facing)))
      .normalize()
  })()
}

/** Builder with a method that three.js's declarations lack. */
type FlatBuilder = NodeBuilder & { isFlatShading(): boolean }

/** Applies tangent-space normals to the view-space normal of a material's `normalNode`. */
function ontoNormal(viewNormal: Node<'vec3'>, normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), viewNormal)
    .mul(scaled(normal, normalScale(material)))
    .normalize()
}

function scaled(normal: Node<'vec3'>, scale: Node<'vec2'>): Node<'vec3'> {
  return vec3(normal.xy.mul(scale), normal.z)
}
