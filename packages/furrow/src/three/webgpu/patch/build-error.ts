import type { Material } from 'three'
import { Fn } from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import type { RendererParts } from '../../material/renderer-parts.ts'

/** Build state of a material's shaders. */
interface Watch {
  /** Builds with an unknown result. */
  builds: Build[]
  error: string | null
}

/** A shader build: during a draw, or asynchronously by `compileAsync`. */
interface Build {
  builder: Builder
  isImmediate: boolean
}

const watches = new WeakMap<Material, Watch>()

/**
 * Wraps a node to record each shader build for `shaderErrorOf`: three.js reports build errors only on the console, and draws nothing.
 */
export function watched(material: Material, node: Node<'vec3'>): Node<'vec3'> {
  const watch: Watch = watches.get(material) ?? { builds: [], error: null }
  watches.set(material, watch)
  return Fn((_: [], nodeBuilder: NodeBuilder) => {
    const builder = nodeBuilder as Builder
    const { _currentRenderContext, _precompilationState } = builder.renderer
    watch.builds.push({ builder, isImmediate: Boolean(_currentRenderContext) && !_precompilationState })
    return node
  })()
}

/** Stops watching a material. */
export function unwatch(material: Material): void {
  watches.delete(material)
}

/** Returns the build error of a material. On WebGPU the result arrives a few frames later. */
export const shaderErrorOf: RendererParts['shaderErrorOf'] = (material) => {
  const watch = watches.get(material)
  if (!watch) return null
  if (watch.builds.length > 0) watch.builds = watch.builds.filter((build) => !inspect(build, watch))
  return watch.error
}

/** Checks a build for errors. Returns false if the result is not known yet. */
function inspect({ builder, isImmediate }: Build, watch: Watch): boolean {
  const { fragmentShader, renderer } = builder
  if (fragmentShader === null) {
    if (isImmediate) watch.error = 'the nodes cannot be built'
    return isImmediate
  }
  const { backend } = renderer
  const pipelines = [...(renderer._pipelines?.caches.values() ?? [])]
    .filter(({ fragmentProgram }) => fragmentProgram?.code === fragmentShader)
    .map((pipeline) => backend.get(pipeline))
  if (pipelines.some(({ pipeline, error }) => !pipeline && !error)) return false
  const check = () => {
    if (pipelines.some((pipeline) => pipeline.error || isUnlinked(pipeline, backend)))
      watch.error = 'invalid pipeline'
  }
  if (!backend.device) check()
  else {
    // Error scopes resolve in order: afterwards three.js has set `error` of its pipelines. A lost device rejects.
    backend.device.pushErrorScope('validation')
    backend.device.popErrorScope().then(check, () => {})
  }
  return true
}

/** Whether a pipeline of the WebGL 2 backend, which is a program, failed to link. */
function isUnlinked({ programGPU }: PipelineData, { gl }: Builder['renderer']['backend']): boolean {
  if (!gl || !programGPU || gl.isContextLost()) return false
  return gl.getProgramParameter(programGPU, gl.LINK_STATUS) === false
}

/** Undocumented internals of a node builder and its renderer. */
type Builder = NodeBuilder & {
  /** Null until the build is complete. */
  fragmentShader: string | null
  renderer: {
    /** Set during `render`. */
    _currentRenderContext: object | null
    /** Set during `compileAsync`, since r187. */
    _precompilationState?: object | null
    _pipelines?: { caches: Map<unknown, { fragmentProgram?: { code: string } }> }
    backend: {
      device?: {
        pushErrorScope(filter: 'validation'): void
        popErrorScope(): Promise<unknown>
      }
      gl?: WebGL2RenderingContext
      get(pipeline: object): PipelineData
    }
  }
}

interface PipelineData {
  /** Undefined until compiled. */
  pipeline?: object
  /** Set if the device rejects the pipeline. */
  error?: boolean
  programGPU?: WebGLProgram
}
