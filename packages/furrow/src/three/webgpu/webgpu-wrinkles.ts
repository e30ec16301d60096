import { type Mesh, REVISION } from 'three'
import { bitangentView, mat3, normalMap, tangentView, varying, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial, type Node } from 'three/webgpu'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { Fetched } from '../material/fetched.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { instancesOf } from '../mesh/instances.ts'
import { isTiled } from '../mesh/wrinkle-uvs.ts'
import type { WrinklesOptions } from '../options.ts'
import { checkThree } from '../three-version.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { checkBatch, influenceFromMap } from './influence/influence.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { isCompiling } from './is-compiling.ts'
import type { NodeChannels } from './mixing/channels.ts'
import { type LayerInfluence, mixNormals } from './mixing/mix-normals.ts'
import { materialProperty, normalScale, typed } from './node.ts'
import { faultOf } from './patch/build-fault.ts'
import { type Added, type Patched, patchNodes } from './patch/patch-nodes.ts'
import { byGradients, bySampler, mapUv, repeat } from './texture-sampling.ts'

/** The wrinkles of a loaded file, whose drivers the loader adds; `Wrinkles` is the same for all else. */
export class WebGPUWrinkles extends WrinklesBase {
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(PARTS, checkThreeFor(mesh), source, options)
  }
}

/** @throws FurrowError when three.js is too old, or lacks what is needed for the mesh. */
export function checkThreeFor(mesh: Mesh): Mesh {
  checkThree('Wrinkles of furrow/webgpu', REVISION)
  if (instancesOf(mesh) === 'batched') checkBatch(mesh)
  return mesh
}

/** The default mode. */
const patch: RendererParts['patch'] = (material, inputs, meshes) => {
  const hasTiles = meshes.some((mesh) => isTiled(mesh, material))
  const uv = varying(mapUv(material))
  // One variable for all samples.
  const wrapped = repeat(uv).toVar()
  const nodes = layerNodes(material, inputs, {
    influence: influenceFromMap(inputs, wrapped, instancesOf(meshes[0])),
    ...(hasTiles ? { uv, sampler: byGradients } : { uv: wrapped, sampler: bySampler }),
  })
  return { ...patchNodes(material, nodes), isFor: (mesh) => hasTiles || !isTiled(mesh, material) }
}

export const PARTS: RendererParts & { channels: Fetched<NodeChannels> } = {
  entry: 'furrow/webgpu',
  canPatch: () => true,
  patch,
  renew: (material) => {
    material.needsUpdate = true
  },
  faultOf,
  isCompiling,
  others: new Fetched(async () => (await import('./modes/other-modes.ts')).OTHER_MODES),
  channels: new Fetched(async () => (await import('./mixing/channels.ts')).CHANNELS),
  unlitMaterial: () => new MeshBasicNodeMaterial({ color: 0, toneMapped: false }),
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).RELIEF_PARTS,
}

/** The default mode: the layers' maps mixed into the material's, lit once. */
function layerNodes(material: Patched, inputs: ShaderInputs, layers: LayerInfluence): Added {
  const { normalNode } = material
  const ownNormal = normalNode ? vec3(0.5, 0.5, 1) : materialProperty('normalMap', 'texture', material).xyz
  const mixed = mixNormals(ownNormal, inputs, layers)
  const added: Added = {
    normalNode: normalNode
      ? ontoNormal(typed(normalNode), mixed, material)
      : normalMap(mixed, normalScale(material)),
  }
  PARTS.channels.value?.add(added, material, inputs, { layers, ownNormal, mixed })
  return added
}

/** Lays stored normals onto a material's own, in view space, that are not those of a map. */
function ontoNormal(own: Node<'vec3'>, stored: Node<'vec3'>, material: Patched): Node<'vec3'> {
  const normal = stored.mul(2).sub(1).toVar()
  const scaled = vec3(normal.xy.mul(normalScale(material)), normal.z)
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), own).mul(scaled).normalize()
}
