import { max, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { RendererParts } from '../material/renderer-parts.ts'
import { influenceFromAreas, influenceFromMap, mapUv } from './influence.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (wrinkled, inputs, table, instances) => {
  const material = new MeshBasicNodeMaterial()
  material.toneMapped = false
  const place = mapUv(wrinkled)
  const influence = table
    ? influenceFromAreas(inputs, table, place)
    : influenceFromMap(inputs, place, instances)
  const shares = influence.toVar()
  material.colorNode = vec3(max(max(shares.x, shares.y), max(shares.z, shares.w)))
  return material
}
