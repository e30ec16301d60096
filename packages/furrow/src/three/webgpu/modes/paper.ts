import type { RendererParts } from '../../material/renderer-parts.ts'
import { influenceFromAreas } from '../influence/influence-from-areas.ts'
import { patchNodes } from '../patch/patch-nodes.ts'
import { mapUv } from '../texture-sampling.ts'
import { paperNodes } from './paper-nodes.ts'

/** Patches a material for the mode `paper` of `WebGPURenderer`, see `paperNodes`. */
export const showPaper: RendererParts['showPaper'] = ({ material, inputs }) => {
  const array = inputs.paper!
  const uv = mapUv(material)
  return patchNodes(material, paperNodes(material, array, uv, influenceFromAreas(inputs, array.table, uv)))
}
