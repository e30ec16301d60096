import type { IUniform, Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ShownMode } from '../../material/patch.ts'

/** An edit of a material's GLSL. */
export interface ShaderEdit {
  /** The same for edits that give the same program. */
  key: string
  uniforms: Record<string, IUniform>
  /** Throws where the shader cannot be edited. */
  apply(shader: WebGLProgramParametersWithUniforms): void
  /** Called where it cannot; the shader then stays as it was. */
  refuse(): void
}

/**
 * Edits a material's own GLSL, after the user's `onBeforeCompile`, if any.
 *
 * @param onCompile called after the shader was edited, before it is compiled.
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
    // Not into the object itself: a ShaderMaterial's is its own, which its copies copy.
    shader.uniforms = { ...shader.uniforms, ...edit.uniforms }
    onCompile?.(renderer)
  }
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${edit.key}`
  return { undo: () => Object.assign(material, original) }
}
