import type { WebGLRenderer } from 'three'
import type { RendererParts } from '../../material/renderer-parts.ts'

/** What three.js keeps of a program: its handle, and what the driver said if `renderer.debug.checkShaderErrors` is set. */
interface Program {
  program: WebGLProgram
  diagnostics?: { fragmentShader: { log: string }; vertexShader: { log: string } }
}

/** Programs that were asked once; the answer does not change. */
const asked = new WeakSet<Program>()

/** Why the program that a material was drawn with last cannot be linked, in the words of the driver. */
export const faultOf: RendererParts['faultOf'] = (material, renderer) => {
  const { properties } = renderer as WebGLRenderer
  const { currentProgram } = properties.get(material) as { currentProgram?: Program }
  if (!currentProgram || asked.has(currentProgram)) return null
  asked.add(currentProgram)
  const { program, diagnostics } = currentProgram
  const gl = (renderer as WebGLRenderer).getContext() as WebGL2RenderingContext
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== false || gl.isContextLost()) return null
  const log =
    diagnostics?.fragmentShader.log || diagnostics?.vertexShader.log || gl.getProgramInfoLog(program)
  return firstLine(log || 'the driver does not say why')
}

function firstLine(text: string): string {
  return text.split('\n', 1)[0]
}
