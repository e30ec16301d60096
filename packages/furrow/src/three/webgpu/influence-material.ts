import { max, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { RendererParts } from '../material/renderer-parts.ts'
import { influenceFromAreas, influenceFromMap } from './influence.ts'
import { materialProperty } from './node.ts'
import { mapUv } from './texture-sampling.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (wrinkled, inputs, table, instances) => {
  const material = new MeshBasicNodeMaterial()
  material.toneMapped = false
  const uv = mapUv(wrinkled)
  const influence = (
    table ? influenceFromAreas(inputs, table, uv) : influenceFromMap(inputs, uv, instances)
  ).toVar()
  const largest = max(max(influence.x, influence.y), max(influence.z, influence.w))
  material.colorNode = materialProperty('color', 'color').mul(vec3(largest))
  return material
}
