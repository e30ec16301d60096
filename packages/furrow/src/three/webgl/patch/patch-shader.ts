import type { IUniform, Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { Edit, Patch } from '../../material/patch.ts'

/** An edit of a material's GLSL. */
export interface ShaderEdit extends Edit {
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
): Patch {
  let current: ShaderEdit | null = edit
  /** Those of all edits so far. */
  const uniforms = { ...edit.uniforms }
  const { onBeforeCompile, customProgramCacheKey } = material
  const original = { onBeforeCompile, customProgramCacheKey }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    try {
      current?.apply(shader)
    } catch {
      return current!.refuse()
    }
    // Not into the object itself: a ShaderMaterial's is its own, which its copies copy. Those of all edits, into the material's own program too:
    // three.js gives a program that it takes up again the uniforms of the one that it built last.
    shader.uniforms = { ...shader.uniforms, ...uniforms }
    if (current) onCompile?.(renderer)
  }
  material.customProgramCacheKey = () =>
    `${customProgramCacheKey.call(material)} furrow ${current?.key ?? ''}`
  return {
    edit,
    setEdit(other) {
      current = other as ShaderEdit | null
      Object.assign(uniforms, current?.uniforms)
    },
    undo: () => Object.assign(material, original),
  }
}
