import { type Mesh, MeshBasicMaterial } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { Fetched } from '../material/fetched.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import { isToon } from '../material/wrinkle-material.ts'
import { instancesOf } from '../mesh/instances.ts'
import { tilingOf } from '../mesh/tiling.ts'
import type { WrinklesOptions } from '../options.ts'
import { bindTension } from '../sources/tension.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import type { SliceSampling } from './influence/influence.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { defaultFragment, instancedVertex, isPatchable, type ShaderVariant } from './mixing/default-shader.ts'
import { type ShaderChannels, valueLayers } from './mixing/value-layers.ts'
import { patchShader, type ShaderEdit } from './patch/patch-shader.ts'
import { faultOf } from './patch/program-fault.ts'
import { layerUniforms, mapUniforms } from './uniforms.ts'

/** The wrinkles of a loaded file, whose drivers the loader adds; `Wrinkles` is the same for all else. */
export class WebGLWrinkles extends WrinklesBase {
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(PARTS, mesh, source, options)
  }
}

/** The default mode. */
const patch: RendererParts['patch'] = (material, inputs, meshes, { refuse, onCompile }) => {
  const { textures } = inputs
  const instances = instancesOf(meshes[0])
  const { isTiled, isFor, isCurrent } = tilingOf(meshes, material)
  const cell = inputs.isAlone() ? 'only' : 'mesh'
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
      shader.fragmentShader = defaultFragment(shader.fragmentShader, variant, PARTS.channels.value)
      if (instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    },
    refuse,
  }
  return { ...patchShader(material, edit, onCompile), isFor, isCurrent }
}

function samplingOf(isTiled: boolean, anisotropy: number): SliceSampling {
  if (!isTiled) return 'sampler'
  return anisotropy > 1 ? 'gradients' : 'level'
}

/**
 * three.js keeps the programs of a material, but the uniforms of the one that it built last: a program that it takes up again, as that of the
 * default mode after `off`, would get none of its own.
 */
const renew: RendererParts['renew'] = (material) => {
  material.dispose()
  material.needsUpdate = true
}

export const PARTS: RendererParts & { channels: Fetched<ShaderChannels> } = {
  entry: 'furrow/three',
  canPatch: ({ fragmentShader, isRawShaderMaterial }) =>
    fragmentShader === undefined || (!isRawShaderMaterial && isPatchable(fragmentShader)),
  patch,
  renew,
  faultOf,
  others: new Fetched(async () => (await import('./modes/other-modes.ts')).OTHER_MODES),
  channels: new Fetched(async () => (await import('./mixing/channels.ts')).CHANNELS),
  unlitMaterial: () => new MeshBasicMaterial({ color: 0, toneMapped: false }),
  bindTension,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).RELIEF_PARTS,
}
