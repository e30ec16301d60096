import { type ModeShaders, OtherModes } from '../../material/other-modes.ts'
import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { patchNodes } from '../patch/patch-nodes.ts'
import { mapUv } from '../texture-sampling.ts'
import { composeMaterial } from './compose-material.ts'
import { showInfluence } from './influence-material.ts'
import { paperNodes } from './paper-nodes.ts'

const paper: ModeShaders['paper'] = (material, inputs) => {
  const array = inputs.paper!
  const uv = mapUv(material)
  return patchNodes(material, paperNodes(material, array, uv, influenceFromAreas(inputs, array.table, uv)))
}

/** What all modes but the default one take, and what shows influence, on `WebGPURenderer`. */
export const OTHER_MODES = new OtherModes({
  paper,
  composeMaterial,
  drawsLevels: false,
  showInfluence,
})
