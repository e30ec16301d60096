import { type ModeShaders, OtherModes } from '../../material/other-modes.ts'
import { areaUniforms } from '../influence/influence-from-areas.ts'
import { patchShader, type ShaderEdit } from '../patch/patch-shader.ts'
import { composeMaterial } from './compose-material.ts'
import { showInfluence } from './influence-material.ts'
import { paperFragment } from './paper-shader.ts'

const paper: ModeShaders['paper'] = (material, inputs, { refuse }) => {
  const { areas } = inputs
  const { diffuseIsSrgb, table, texture } = inputs.paper!
  const edit: ShaderEdit = {
    key: `paper ${areas.channels} ${diffuseIsSrgb}`,
    uniforms: { ...areaUniforms(inputs, table), furrowColours: { value: texture } },
    apply(shader) {
      shader.fragmentShader = paperFragment(shader.fragmentShader, areas.channels, diffuseIsSrgb)
    },
    refuse,
  }
  return patchShader(material, edit)
}

/** What all modes but the default one take, and what shows influence, on `WebGLRenderer`. */
export const OTHER_MODES = new OtherModes({
  paper,
  composeMaterial,
  drawsLevels: true,
  showInfluence,
})
