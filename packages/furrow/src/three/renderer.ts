import type { WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { FurrowError } from '../core/error.ts'

/** One of three.js's two renderers. */
export type AnyRenderer = WebGLRenderer | WebGPURenderer

/** An entry of the package: each is for one renderer. */
export type Entry = 'furrow/three' | 'furrow/webgpu'

/**
 * Checks that an entry can work with a renderer.
 *
 * @param who names the class of the entry.
 * @returns what is wrong; null if nothing is.
 */
export function rendererProblem(renderer: AnyRenderer, entry: Entry, who: string): FurrowError | null {
  const { isWebGLRenderer, isWebGPURenderer } = renderer as {
    isWebGLRenderer?: true
    isWebGPURenderer?: true
  }
  const isOther = entry === 'furrow/three' ? isWebGPURenderer : isWebGLRenderer
  if (!isOther) return null
  const right: Entry = entry === 'furrow/three' ? 'furrow/webgpu' : 'furrow/three'
  return new FurrowError({
    code: 'unsupported',
    who: `${who} of ${entry}`,
    what: 'cannot draw with this renderer',
    value: isWebGPURenderer ? 'WebGPURenderer' : 'WebGLRenderer',
    limit: isWebGPURenderer ? 'WebGLRenderer' : 'WebGPURenderer',
    remedy: `take it from ${right} instead, and the loader plugin too; until then the face has no wrinkles`,
  })
}
