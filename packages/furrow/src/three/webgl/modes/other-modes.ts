import { ComposedMap, composedFormat } from '../../material/composed-map.ts'
import type { OtherModes } from '../../material/other-modes.ts'
import { showInfluenceBy } from '../../material/show-influence.ts'
import { updatePaper } from '../../material/update-paper.ts'
import { areaUniforms } from '../influence/influence-from-areas.ts'
import { patchShader } from '../patch/patch-shader.ts'
import { composeMaterial } from './compose-material.ts'
import { showInfluence } from './influence-material.ts'
import { paperFragment } from './paper-shader.ts'

const patchPaper: OtherModes['patchPaper'] = (material, inputs, refuse) => {
  const { areas, paper } = inputs
  const { diffuseIsSrgb, table, texture } = paper!
  return patchShader(material, {
    key: `paper ${areas.channels} ${diffuseIsSrgb}`,
    uniforms: { ...areaUniforms(inputs, table), furrowColours: { value: texture } },
    edit(shader) {
      shader.fragmentShader = paperFragment(shader.fragmentShader, areas.channels, diffuseIsSrgb)
    },
    refuse,
  })
}

/** What all modes but the default one take, and what shows influence, on `WebGLRenderer`. */
export const OTHER_MODES: OtherModes = {
  updatePaper,
  patchPaper,
  ComposedMap,
  composedFormat,
  drawsLevels: true,
  composeMaterial,
  showInfluence: showInfluenceBy(showInfluence),
}
