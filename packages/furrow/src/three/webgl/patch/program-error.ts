import type { WebGLRenderer } from 'three'
import type { RendererParts } from '../../material/renderer-parts.ts'

/** three.js's record of a program: its handle, and the driver's logs if `renderer.debug.checkShaderErrors` is set. */
interface Program {
  program: WebGLProgram
  diagnostics?: { fragmentShader: { log: string }; vertexShader: { log: string } }
}

/** Programs that were already checked; the result does not change. */
const checked = new WeakSet<Program>()

/** Returns the driver's message if the material's last program failed to link. */
export const shaderErrorOf: RendererParts['shaderErrorOf'] = (material, renderer) => {
  const { properties } = renderer as WebGLRenderer
  const { currentProgram } = properties.get(material) as { currentProgram?: Program }
  if (!currentProgram || checked.has(currentProgram)) return null
  checked.add(currentProgram)
  const { program, diagnostics } = currentProgram
  const gl = (renderer as WebGLRenderer).getContext() as WebGL2RenderingContext
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== false || gl.isContextLost()) return null
  const log =
    diagnostics?.fragmentShader.log || diagnostics?.vertexShader.log || gl.getProgramInfoLog(program)
  return firstLine(log || 'no message from the driver')
}

function firstLine(text: string): string {
  return text.split('\n', 1)[0]
}
