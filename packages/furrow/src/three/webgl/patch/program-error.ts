import type { WebGLRenderer } from 'three'
import type { RendererParts } from '../../material/renderer-parts.ts'

/** A shader program as three.js stores it. `diagnostics` needs `renderer.debug.checkShaderErrors`. */
interface Program {
  program: WebGLProgram
  diagnostics?: { fragmentShader: { log: string }; vertexShader: { log: string } }
}

const checked = new WeakSet<Program>()

/** Returns the message of the GPU driver if the current program of a material failed to link; null otherwise, or if it was checked before. */
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
