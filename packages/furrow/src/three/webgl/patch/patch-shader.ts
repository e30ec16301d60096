import type { IUniform, Material, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { Patch } from '../../material/patch.ts'

/** How a material's GLSL is edited. */
interface ShaderPatch {
  /** The same for edits that give the same program. */
  key: string
  uniforms: Record<string, IUniform>
  /** Throws where the shader cannot be edited. */
  edit(shader: WebGLProgramParametersWithUniforms): void
  /** Called where it cannot; the shader then stays as it was. */
  refuse(): void
  /** Called after it was edited, before it is compiled. */
  onCompile?(renderer: WebGLRenderer): void
}

/** Edits a material's own GLSL, after the user's `onBeforeCompile`, if any. */
export function patchShader(
  material: Material,
  { key, uniforms, edit, refuse, onCompile }: ShaderPatch,
): Patch {
  let isShown = true
  const { onBeforeCompile, customProgramCacheKey } = material
  const original = { onBeforeCompile, customProgramCacheKey }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    try {
      if (isShown) edit(shader)
    } catch {
      return refuse()
    }
    // Not into the object itself: a ShaderMaterial's is its own, which its copies copy. Into that of the material's own program too: three.js
    // gives a program that it takes up again the uniforms of the one that it built last.
    shader.uniforms = { ...shader.uniforms, ...uniforms }
    if (isShown) onCompile?.(renderer)
  }
  material.customProgramCacheKey = () =>
    `${customProgramCacheKey.call(material)} furrow ${isShown ? key : ''}`
  return {
    setShown(value) {
      isShown = value
    },
    undo: () => Object.assign(material, original),
  }
}
