import type { WebGLRenderer } from 'three'
// biome-ignore lint/suspicious/noTsIgnore: needed in the published declarations; `@ts-expect-error` would fail here
/** @ts-ignore three.js before r167 has no `three/webgpu`; with it, `WebGPURenderer` has the type `any`. */
import type { WebGPURenderer } from 'three/webgpu'
import { FurrowError } from '../core/error.ts'

/** A `WebGLRenderer` or `WebGPURenderer` of three.js. */
export type AnyRenderer = WebGLRenderer | WebGPURenderer

/** Entry points of the package. Each supports one class of renderers. */
export type Entry = 'furrow/three' | 'furrow/webgpu'

/**
 * Checks that an entry point supports a renderer.
 *
 * @param who name of the class, for errors.
 * @throws FurrowError if the renderer needs the other entry point.
 */
export function checkRenderer(renderer: AnyRenderer, entry: Entry, who: string): void {
  const problem = problemOf(renderer, entry, who)
  if (problem) throw problem
}

const refused = new WeakSet<AnyRenderer>()

/** Whether a renderer needs the other entry point. If so, logs an error, once per renderer. */
export function isRefused(renderer: AnyRenderer, entry: Entry, who: string): boolean {
  const problem = problemOf(renderer, entry, who)
  if (!problem) return false
  if (!refused.has(renderer)) console.error(problem.message)
  refused.add(renderer)
  return true
}

/** WebGL 2 extensions and WebGPU features that filter and blend 32-bit float textures. */
const FLOAT_EXTENSIONS = ['OES_texture_float_linear', 'EXT_float_blend']
const FLOAT_FEATURES = ['float32-filterable', 'float32-blendable']

/** Whether a renderer can blend into and filter 32-bit float textures. */
export function filtersFloats(renderer: AnyRenderer): boolean {
  const { backend } = renderer as Partial<Pick<WebGPURenderer, 'backend'>>
  if ((backend as { isWebGPUBackend?: true } | undefined)?.isWebGPUBackend)
    return FLOAT_FEATURES.every((name) => (renderer as WebGPURenderer).hasFeature(name))
  const gl = renderer.getContext() as WebGL2RenderingContext
  return FLOAT_EXTENSIONS.every((name) => gl.getExtension(name) !== null)
}

function problemOf(renderer: AnyRenderer, entry: Entry, who: string): FurrowError | null {
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
    problem: 'unsupported renderer',
    value: isWebGPURenderer ? 'WebGPURenderer' : 'WebGLRenderer',
    limit: isWebGPURenderer ? 'WebGLRenderer' : 'WebGPURenderer',
    remedy: `import ${who} and the loader plugin from ${right}; until then the face has no wrinkles`,
  })
}
