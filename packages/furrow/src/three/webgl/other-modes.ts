import { ComposedMap, composedSize } from '../material/composed-map.ts'
import type { OtherModes } from '../material/other-modes.ts'
import { packPaperArray } from '../material/paper-array.ts'
import { composeMaterial } from './compose-material.ts'
import { paperFragment } from './paper-shader.ts'
import { patchShader } from './patch-shader.ts'
import { areaUniforms } from './uniforms.ts'

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

/** What all modes but the default one take, on `WebGLRenderer`. */
export const OTHER_MODES: OtherModes = {
  packPaperArray,
  patchPaper,
  ComposedMap,
  composedSize,
  composeMaterial,
}
