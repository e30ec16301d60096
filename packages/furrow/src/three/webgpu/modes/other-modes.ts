import { ComposedMap, composedFormat } from '../../material/composed-map.ts'
import type { OtherModes } from '../../material/other-modes.ts'
import { showInfluenceBy } from '../../material/show-influence.ts'
import { updatePaper } from '../../material/update-paper.ts'
import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { patchNodes } from '../patch/patch-nodes.ts'
import { mapUv } from '../texture-sampling.ts'
import { composeMaterial } from './compose-material.ts'
import { showInfluence } from './influence-material.ts'
import { paperNodes } from './paper-nodes.ts'

const patchPaper: OtherModes['patchPaper'] = (material, inputs) => {
  const paper = inputs.paper!
  const uv = mapUv(material)
  return patchNodes(material, paperNodes(material, paper, uv, influenceFromAreas(inputs, paper.table, uv)))
}

/** What all modes but the default one take, and what shows influence, on `WebGPURenderer`. */
export const OTHER_MODES: OtherModes = {
  updatePaper,
  patchPaper,
  ComposedMap,
  composedFormat,
  drawsLevels: false,
  composeMaterial,
  showInfluence: showInfluenceBy(showInfluence),
}
