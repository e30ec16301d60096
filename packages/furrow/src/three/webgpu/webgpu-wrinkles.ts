import type { Mesh, MeshStandardMaterial } from 'three'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { needChannels } from '../material/channels.ts'
import { Fetched } from '../material/fetched.ts'
import type { ShownMode } from '../material/patch.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { WrinkleMaterial } from '../material/wrinkle-material.ts'
import { instancesOf } from '../mesh/instances.ts'
import { tilingOf } from '../mesh/tiling.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { bindComputedTension } from './compute/computed-tension.ts'
import { checkBatch } from './influence/influence.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { isCompiling } from './is-compiling.ts'
import type { NodeChannels } from './mixing/channels.ts'
import { layerNodes } from './mixing/layer-nodes.ts'
import { faultOf } from './patch/build-fault.ts'
import { patchNodes } from './patch/patch-nodes.ts'

/** The wrinkles of a loaded file, whose drivers the loader adds; `Wrinkles` is the same for all else. */
export class WebGPUWrinkles extends WrinklesBase {
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(PARTS, withBatchChecked(mesh), source, options)
  }
}

/** @throws FurrowError when three.js lacks what is needed for a `BatchedMesh`. */
export function withBatchChecked(mesh: Mesh): Mesh {
  if (instancesOf(mesh) === 'batched') checkBatch(mesh)
  return mesh
}

/** The default mode. */
const patch = (material: WrinkleMaterial, inputs: ShaderInputs, meshes: readonly Mesh[]): ShownMode => {
  const { isTiled, isFor, isCurrent: isTiledAsBefore } = tilingOf(meshes, material)
  const hasChannels = needChannels(inputs.textures.layers, material)
  const owned = ownedMaps(material)
  const isCurrent = () => isTiledAsBefore() && (!hasChannels || ownedMaps(material) === owned)
  const added = layerNodes(material, inputs, meshes[0], isTiled, PARTS.channels.value)
  return { ...patchNodes(material, added), isFor, isCurrent }
}

/** Which of the maps that layers are mixed into a material has, as bits: nodes are made for these. */
function ownedMaps(material: WrinkleMaterial): number {
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  return (map ? 1 : 0) + (roughnessMap ? 2 : 0) + (aoMap ? 4 : 0)
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
  bindTension: bindComputedTension,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).RELIEF_PARTS,
}
