/** The nodes of the default mode: the layers' maps mixed into the material's, lit once. */
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
 * Mixes the layers' maps into a material's own.
 *
 * @param mesh one of the face.
 * @param isTiled whether texture coordinates leave 0..1, and so wrap.
 */
export function layerNodes(material: Patched, inputs: ShaderInputs, mesh: Mesh, isTiled: boolean): Added {
  const { normalNode: node } = material
  // A material whose normals are those of a node has a flat map under them.
  const own = node ? vec3(0, 0, 1) : unpack(materialProperty('normalMap', 'texture', material).xyz)
  const layers = layersOf(material, inputs, mesh, isTiled)
  const mixed = mixNormals(own, inputs, layers)
  const added: Added = {
    normalNode: node ? ontoNormal(typed(node), mixed, material) : inView(mixed, material),
  }
  addValues(added, material, inputs, { layers, ownNormal: own, mixed })
  return added
}

/** The influence of a face's layers, and how their maps are sampled. */
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

/** A normal in tangent space as three.js's `normalMap` gives one of a map, which would have to be packed for that to unpack it. */
function inView(normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return Fn((_: [], builder: NodeBuilder) => {
    const scale = normalScale(material)
    const facing = (builder as FlatBuilder).isFlatShading() ? negateOnBackSide(typed(scale)) : scale
    return typed<'mat3'>(TBNViewMatrix)
      .mul(scaled(normal, typed(facing)))
      .normalize()
  })()
}

/** What three.js's declarations lack. */
type FlatBuilder = NodeBuilder & { isFlatShading(): boolean }

/** Lays normals onto a material's own, in view space, that are not those of a map. */
function ontoNormal(own: Node<'vec3'>, normal: Node<'vec3'>, material: Patched): Node<'vec3'> {
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), own)
    .mul(scaled(normal, normalScale(material)))
    .normalize()
}

function scaled(normal: Node<'vec3'>, scale: Node<'vec2'>): Node<'vec3'> {
  return vec3(normal.xy.mul(scale), normal.z)
}
