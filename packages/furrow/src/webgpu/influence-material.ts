import { max, uv, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { RendererParts } from '../three/Wrinkles.ts'
import { influenceFromAreas, influenceFromMap } from './influence.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (inputs, table, instanced) => {
  const material = new MeshBasicNodeMaterial()
  material.toneMapped = false
  const influence = table
    ? influenceFromAreas(inputs, table, uv())
    : influenceFromMap(inputs, uv(), instanced)
  const shares = influence.toVar()
  material.colorNode = vec3(max(max(shares.x, shares.y), max(shares.z, shares.w)))
  return material
}
