import type { IUniform, Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ShownMode } from '../../material/patch.ts'

/** An edit of a material's GLSL. */
export interface ShaderEdit {
  /** Cache key, equal for edits that change the code in the same way. */
  key: string
  uniforms: Record<string, IUniform>
  /** Edits the shader. Throws an error if the shader is unsupported. */
  apply(shader: WebGLProgramParametersWithUniforms): void
  /** Called if `apply` throws an error. */
  refuse(): void
}

/**
 * Patches a material so that three.js edits its GLSL before compilation. An `onBeforeCompile` callback of the page runs first.
 *
 * @param onCompile called after the edit, before compilation.
 */
export function patchShader(
  material: Material,
  edit: ShaderEdit,
  onCompile?: (renderer: WebGLRenderer) => void,
): Pick<ShownMode, 'undo'> {
  const { onBeforeCompile, customProgramCacheKey } = material
  const original = { onBeforeCompile, customProgramCacheKey }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    try {
      edit.apply(shader)
    } catch {
      return edit.refuse()
    }
    // A new object, because `shader.uniforms` may be the `uniforms` of a `ShaderMaterial`, and clones of the material would copy the additions.
    shader.uniforms = { ...shader.uniforms, ...edit.uniforms }
    onCompile?.(renderer)
  }
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${edit.key}`
  return { undo: () => Object.assign(material, original) }
}
