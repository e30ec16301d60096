import type { MeshStandardMaterial } from 'three'
import { float, max, vec2, vec4 } from 'three/tsl'
import type { Node, NodeMaterial } from 'three/webgpu'
import { BLOOD_AT_REST } from '../../../core/blood.ts'
import type { Channels } from '../../material/channels.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { valueTextures } from '../../material/value-textures.ts'
import { isToon } from '../../material/wrinkle-material.ts'
import { CHANNELS as COMPONENTS, inputUniform, materialProperty } from '../node.ts'
import type { Added, Patched } from '../patch/patch-nodes.ts'
import { shadowHighlights } from './micro-shadow.ts'
import type { LayerInfluence } from './mix-normals.ts'
import { bloodColour, bloodOf, toonColour, valueMixer } from './mix-values.ts'

/** What adds nodes for the layers' other maps, and for materials that light in steps. */
export interface NodeChannels extends Channels {
  /** Mixes them. */
  add(added: Added, material: Patched, inputs: ShaderInputs, mixing: Mixing): void
  /** Takes visibility and blood that `storedValues` gave. */
  addStored(added: Added, material: Patched, inputs: ShaderInputs, stored: Node<'vec2'>): void
  /** The layers' visibility, and blood as blood maps store it, where its amplitude is the largest of the layers. */
  storedValues(inputs: ShaderInputs, layers: LayerInfluence): Node<'vec2'>
  /** The material's own occlusion with that of the layers. */
  mixOcclusion(own: Node<'float'>, inputs: ShaderInputs, layers: LayerInfluence): Node<'float'>
}

/** The normals that are mixed, unpacked, and by what. */
interface Mixing {
  layers: LayerInfluence
  ownNormal: Node<'vec3'>
  mixed: Node<'vec3'>
  /** Where the material's own is sampled already. */
  ownOcclusion?: Node<'float'> | undefined
}

/** What layers with other maps than normals take on `WebGPURenderer`, and materials that light in steps. */
export const CHANNELS: NodeChannels = { valueTextures, add, addStored, storedValues, mixOcclusion }

function add(
  added: Added,
  material: Patched,
  inputs: ShaderInputs,
  { layers, ownNormal, mixed, ownOcclusion }: Mixing,
): void {
  const { baseColor, roughness, occlusion, blood } = inputs.textures.values
  const { roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  const { mixColour, mixValue } = valueMixer(inputs, layers)
  if (baseColor || blood || isToon(material)) {
    const own = ownColourOf(material)
    const mapped = baseColor ? mixColour(own.rgb) : own.rgb
    const unflushed = materialProperty('color', 'color', material).mul(mapped)
    const colour = blood ? bloodColour(unflushed, mixValue('blood', float(0))) : unflushed
    added.colorNode = vec4(isToon(material) ? toonColour(colour, ownNormal, mixed) : colour, own.a)
  }
  if (roughness && 'roughness' in material) {
    const own = roughnessMap ? materialProperty('roughnessMap', 'texture', material).g : float(1)
    added.roughnessNode = materialProperty('roughness', 'float', material).mul(mixValue('roughness', own))
  }
  if (occlusion && 'aoMap' in material) {
    const visibility = mixValue('occlusion', float(1))
    const own = () => ownOcclusion ?? materialProperty('aoMap', 'texture', material).r
    addOcclusion(added, material, aoMap ? mixValue('occlusion', own()) : visibility, visibility)
  }
}

function addStored(added: Added, material: Patched, inputs: ShaderInputs, stored: Node<'vec2'>): void {
  const { occlusion, blood } = inputs.textures.values
  const { aoMap } = material as Partial<MeshStandardMaterial>
  if (blood) {
    const own = ownColourOf(material)
    const colour = materialProperty('color', 'color', material).mul(own.rgb)
    added.colorNode = vec4(bloodColour(colour, bloodOf(stored.y).mul(bloodRange(inputs))), own.a)
  }
  if (occlusion && 'aoMap' in material) {
    const visibility = stored.x
    addOcclusion(
      added,
      material,
      aoMap ? materialProperty('aoMap', 'texture', material).r : visibility,
      visibility,
    )
  }
}

function storedValues(inputs: ShaderInputs, layers: LayerInfluence): Node<'vec2'> {
  const { occlusion, blood } = inputs.textures.values
  const { mixValue } = valueMixer(inputs, layers)
  const share = blood ? mixValue('blood', float(0)).div(bloodRange(inputs)).clamp(-1, 1) : float(0)
  const stored = share
    .mul(255 - BLOOD_AT_REST)
    .add(BLOOD_AT_REST)
    .div(255)
  return vec2(occlusion ? mixValue('occlusion', float(1)) : 1, stored)
}

function mixOcclusion(own: Node<'float'>, inputs: ShaderInputs, layers: LayerInfluence): Node<'float'> {
  return valueMixer(inputs, layers).mixValue('occlusion', own)
}

/** Colours of the material's own map. */
function ownColourOf(material: Patched): Node<'vec4'> {
  const { map } = material as Partial<MeshStandardMaterial>
  return map ? materialProperty('map', 'texture', material) : vec4(1)
}

/**
 * @param value of the material's own occlusion map with the layers'.
 * @param visibility the layers' occlusion over a value of 1.
 */
function addOcclusion(
  added: Added,
  material: Patched,
  value: Node<'float'>,
  visibility: Node<'float'>,
): void {
  const intensity = materialProperty('aoMapIntensity', 'float', material)
  const { aoMap } = material as Partial<MeshStandardMaterial>
  added.aoNode = aoMap ? value.sub(1).mul(intensity).add(1) : value
  added.setupLightingModel = function (this: NodeMaterial) {
    const model = Object.getPrototypeOf(this).setupLightingModel.call(this)
    return shadowHighlights(model, visibility)
  }
}

/** The largest amplitude of the layers' blood. */
function bloodRange({ bloodAmplitude, textures }: ShaderInputs): Node<'float'> {
  const amplitudes = inputUniform<'vec4'>(bloodAmplitude)
  return textures.layers.reduce<Node<'float'>>(
    (range, _, layer) => max(range, amplitudes[COMPONENTS[layer]]),
    float(0.0001),
  )
}
