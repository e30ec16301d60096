import type { MeshStandardMaterial } from 'three'
import { vec3, vec4 } from 'three/tsl'
import type { Node, NodeMaterial } from 'three/webgpu'
import type { Channels } from '../../material/channels.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { valueTextures } from '../../material/value-textures.ts'
import { isToon } from '../../material/wrinkle-material.ts'
import type { ValueKind } from '../../material/wrinkle-textures.ts'
import { materialProperty } from '../node.ts'
import type { Added, Patched } from '../patch/patch-nodes.ts'
import { shadowHighlights } from './micro-shadow.ts'
import type { LayerInfluence } from './mix-normals.ts'
import { bloodColour, mixValues, texelReader, toonColour } from './mix-values.ts'

/** What adds nodes for the layers' other maps, and for materials that light in steps. */
export interface NodeChannels extends Channels {
  add(added: Added, material: Patched, inputs: ShaderInputs, mixing: Mixing): void
}

/** The normals that are mixed, as stored, and by what. */
interface Mixing {
  layers: LayerInfluence
  ownNormal: Node<'vec3'>
  mixed: Node<'vec3'>
}

/** What layers with other maps than normals take on `WebGPURenderer`, and materials that light in steps. */
export const CHANNELS: NodeChannels = { valueTextures, add }

function add(
  added: Added,
  material: Patched,
  inputs: ShaderInputs,
  { layers, ownNormal, mixed }: Mixing,
): void {
  const { baseColor, roughness, occlusion, blood } = inputs.textures.values
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  const read = texelReader(layers)
  const mixInto = (kind: ValueKind, own: Node<'vec3'>) => mixValues(kind, own, inputs, layers.influence, read)
  if (baseColor || blood || isToon(material)) {
    const own = map ? materialProperty('map', 'texture', material) : vec4(1)
    const mapped = baseColor ? mixInto('baseColor', own.rgb) : own.rgb
    const unflushed = materialProperty('color', 'color', material).mul(mapped)
    const colour = blood ? bloodColour(unflushed, mixInto('blood', vec3(0)).x) : unflushed
    added.colorNode = vec4(isToon(material) ? toonColour(colour, ownNormal, mixed) : colour, own.a)
  }
  if (roughness && 'roughness' in material) {
    const own = roughnessMap ? vec3(materialProperty('roughnessMap', 'texture', material).g) : vec3(1)
    const value = mixInto('roughness', own).x
    added.roughnessNode = materialProperty('roughness', 'float', material).mul(value)
  }
  if (occlusion && 'aoMap' in material) {
    const own = aoMap ? vec3(materialProperty('aoMap', 'texture', material).r) : vec3(1)
    const value = mixInto('occlusion', own).x
    const intensity = materialProperty('aoMapIntensity', 'float', material)
    added.aoNode = aoMap ? value.sub(1).mul(intensity).add(1) : value
    const visibility = aoMap ? mixInto('occlusion', vec3(1)).x : value
    added.setupLightingModel = function (this: NodeMaterial) {
      const model = Object.getPrototypeOf(this).setupLightingModel.call(this)
      return shadowHighlights(model, visibility)
    }
  }
}
