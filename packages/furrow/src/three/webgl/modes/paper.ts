import type { RendererParts } from '../../material/renderer-parts.ts'
import { areaUniforms } from '../influence/influence-from-areas.ts'
import { patchShader, type ShaderEdit } from '../patch/patch-shader.ts'
import { paperFragment } from './paper-shader.ts'

/** Patches a material for the mode `paper` of `WebGLRenderer`, see `paperFragment`. */
export const showPaper: RendererParts['showPaper'] = ({ material, inputs, refuse }) => {
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
