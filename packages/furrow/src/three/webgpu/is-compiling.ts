import type { RendererParts } from '../material/renderer-parts.ts'

/** Undocumented internals of `WebGPURenderer`. */
interface Compiler {
  /** Set while `compileAsync` traverses a scene. */
  _compilationPromises?: object | null
  /** Undefined before r187. */
  _precompilationState?: object | null
}

/**
 * Whether `compileAsync` of three.js r186 is traversing a scene. Nothing may be drawn meanwhile. A `render` call begins a frame, and three.js
 * then drops render lists that were unused for ten frames. `compileAsync` may still be using one of these lists. r187 has no such problem.
 */
export const isCompiling: RendererParts['isCompiling'] = (renderer) => {
  const { _compilationPromises, _precompilationState } = renderer as Compiler
  return Boolean(_compilationPromises) && _precompilationState === undefined
}
