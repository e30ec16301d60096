import type { RendererParts } from '../material/renderer-parts.ts'

/** Undocumented internals of `WebGPURenderer`. */
interface Compiler {
  /** Set while `compileAsync` traverses a scene. */
  _compilationPromises?: object | null
  /** Since r187. */
  _precompilationState?: object | null
}

/**
 * Whether r186 is traversing a scene in `compileAsync`. Drawing an influence map then would begin a frame, which drops render lists unused
 * for ten frames, including the scene's. Fixed in r187.
 */
export const isCompiling: RendererParts['isCompiling'] = (renderer) => {
  const { _compilationPromises, _precompilationState } = renderer as Compiler
  return Boolean(_compilationPromises) && _precompilationState === undefined
}
