import type { MeshStandardMaterial } from 'three'
import { float, vec4 } from 'three/tsl'
import type { Node, NodeMaterial } from 'three/webgpu'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { isToon } from '../../material/wrinkle-material.ts'
import { materialProperty } from '../node.ts'
import type { Added, Patched } from '../patch/patch-nodes.ts'
import { shadowHighlights } from './micro-shadow.ts'
import type { LayerInfluence } from './mix-normals.ts'
import { bloodColour, toonColour, valueMixer } from './mix-values.ts'

interface Mixing {
  layers: LayerInfluence
  /** Tangent-space normal of the material. */
  ownNormal: Node<'vec3'>
  /** Tangent-space normal after the normals of layers are mixed in. */
  mixed: Node<'vec3'>
}

/**
 * Adds nodes that mix the value maps of layers (base colour, roughness, occlusion, blood) into the maps of a material, and draw wrinkles as
 * dark lines on toon materials.
 */
export function addValues(
  added: Added,
  material: Patched,
  inputs: ShaderInputs,
  { layers, ownNormal, mixed }: Mixing,
): void {
  const { baseColor, roughness, occlusion, blood } = inputs.textures.values
  const { roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  const { mixColour, mixValue } = valueMixer(inputs, layers)
  if (baseColor || blood || isToon(material)) {
    const texel = ownColourOf(material)
    const mapped = baseColor ? mixColour(texel.rgb) : texel.rgb
    const unflushed = materialProperty('color', 'color', material).mul(mapped)
    const colour = blood ? bloodColour(unflushed, mixValue('blood', float(0))) : unflushed
    added.colorNode = vec4(isToon(material) ? toonColour(colour, ownNormal, mixed) : colour, texel.a)
  }
  if (roughness && 'roughness' in material) {
    const ownRoughness = roughnessMap ? materialProperty('roughnessMap', 'texture', material).g : float(1)
    added.roughnessNode = materialProperty('roughness', 'float', material).mul(
      mixValue('roughness', ownRoughness),
    )
  }
  if (occlusion && 'aoMap' in material) {
    const visibility = mixValue('occlusion', float(1))
    const value = aoMap ? mixValue('occlusion', materialProperty('aoMap', 'texture', material).r) : visibility
    addOcclusion(added, material, value, visibility)
  }
}

/** Returns the colour of the material's base colour map; 1 without a map. */
function ownColourOf(material: Patched): Node<'vec4'> {
  const { map } = material as Partial<MeshStandardMaterial>
  return map ? materialProperty('map', 'texture', material) : vec4(1)
}

/**
 * @param value occlusion map of the material, mixed with the occlusion maps of layers.
 * @param visibility occlusion maps of layers, mixed into 1.
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
