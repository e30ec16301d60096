import { max, uv, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { WrinkleInputs } from '../three/Wrinkles.ts'
import { areaCount, influence } from './functions.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export function influenceMaterial(inputs: WrinkleInputs): MeshBasicNodeMaterial {
  const material = new MeshBasicNodeMaterial()
  material.toneMapped = false
  const shares = influence(inputs.areas, inputs.activations, areaCount(inputs.areaCount), uv()).toVar()
  material.colorNode = vec3(max(max(shares.x, shares.y), max(shares.z, shares.w)))
  return material
}
