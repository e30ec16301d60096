import type { WebGLRenderer } from 'three'
// biome-ignore lint/suspicious/noTsIgnore: it is for those who read the declarations, there is no error here
/** @ts-ignore Releases of three.js before r167 have no `three/webgpu`: the type is then `any`. */
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
 * @throws FurrowError that names the other entry.
 */
export function checkRenderer(renderer: AnyRenderer, entry: Entry, who: string): void {
  const problem = problemOf(renderer, entry, who)
  if (problem) throw problem
}

/** Renderers that the console was told of. */
const refused = new WeakSet<AnyRenderer>()

/** Whether the renderer is the other entry's. The console says so, once for each renderer. */
export function isRefused(renderer: AnyRenderer, entry: Entry, who: string): boolean {
  const problem = problemOf(renderer, entry, who)
  if (!problem) return false
  if (!refused.has(renderer)) console.error(problem.message)
  refused.add(renderer)
  return true
}

/** What textures of 32-bit floats need, to be filtered and to be blended: by WebGL 2, and by WebGPU. */
const FLOAT_EXTENSIONS = ['OES_texture_float_linear', 'EXT_float_blend']
const FLOAT_FEATURES = ['float32-filterable', 'float32-blendable']

/** Whether a renderer can add up 32-bit floats in a texture, and filter it. */
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
    problem: 'cannot draw with this renderer',
    value: isWebGPURenderer ? 'WebGPURenderer' : 'WebGLRenderer',
    limit: isWebGPURenderer ? 'WebGLRenderer' : 'WebGPURenderer',
    remedy: `take it from ${right} instead, and the loader plugin too; until then the face has no wrinkles`,
  })
}
