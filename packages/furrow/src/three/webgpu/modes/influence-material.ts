import { Color } from 'three'
import { max, vec3 } from 'three/tsl'
import type { ShowInfluence } from '../../material/influence-view.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { materialProperty } from '../node.ts'
import { mapUv, repeat } from '../texture-sampling.ts'

/**
 * Patches an unlit material to show the influence map of a face in gray, or the weights of areas if a table of activations is given. Black =
 * no wrinkles, white = fully visible.
 */
export const showInfluence: ShowInfluence = (material, { wrinkled, inputs, instances }, table) => {
  const uv = mapUv(wrinkled)
  const influence = (
    table ? influenceFromAreas(inputs, table, uv) : influenceFromMap(inputs, repeat(uv).toVar(), instances)
  ).toVar()
  const largest = max(max(influence.x, influence.y), max(influence.z, influence.w))
  const colorNode = materialProperty('color', 'color', material).mul(vec3(largest))
  Object.assign(material, { color: new Color(1, 1, 1), colorNode, needsUpdate: true })
}
