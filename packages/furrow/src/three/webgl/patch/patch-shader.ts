import type { IUniform, Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { ShownMode } from '../../material/patch.ts'

/** An edit of a material's GLSL. */
export interface ShaderEdit {
  /** Cache key; equal for edits that give the same program. */
  key: string
  uniforms: Record<string, IUniform>
  /** Edits the shader. Throws if it is unsupported. */
  apply(shader: WebGLProgramParametersWithUniforms): void
  /** Called if `apply` throws; the shader is left unchanged. */
  refuse(): void
}

/**
 * Patches a material's GLSL, after the user's `onBeforeCompile`, if any.
 *
 * @param onCompile called with the patched shader, before compilation.
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
    // A new object: a ShaderMaterial passes its own `uniforms`, which its clones would copy.
    shader.uniforms = { ...shader.uniforms, ...edit.uniforms }
    onCompile?.(renderer)
  }
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${edit.key}`
  return { undo: () => Object.assign(material, original) }
}
