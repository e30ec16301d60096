import type { RendererParts } from '../material/renderer-parts.ts'

/** What three.js does not document of its renderer. */
interface Compiler {
  /** Null but while `compileAsync` goes through a scene. */
  _compilationPromises?: object | null
  /** From r187 on. */
  _precompilationState?: object | null
}

/**
 * Whether r186 goes through a scene that it compiles. Drawn meanwhile, an influence map would begin a frame, which clears the lists of what was
 * not drawn in the last ten: that of the scene too. From r187 on `compileAsync` allows for it.
 */
export const isCompiling: RendererParts['isCompiling'] = (renderer) => {
  const { _compilationPromises, _precompilationState } = renderer as Compiler
  return Boolean(_compilationPromises) && _precompilationState === undefined
}
