import type { Material } from 'three'
import { Fn } from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import type { RendererParts } from '../../material/renderer-parts.ts'

interface Watch {
  /** Builds whose result is not known yet. */
  builds: Build[]
  error: string | null
}

interface Build {
  builder: Builder
  /** Whether the build runs during a `render` call, and not in `compileAsync`. */
  isImmediate: boolean
}

const watches = new WeakMap<Material, Watch>()

/**
 * Wraps a node so that each build of a shader that contains the node is recorded. `shaderErrorOf` checks the recorded builds, because
 * three.js reports build errors only on the console.
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

export function unwatch(material: Material): void {
  watches.delete(material)
}

/** Returns the build error of a material, or null. On WebGPU an error is known a few frames after the build. */
export const shaderErrorOf: RendererParts['shaderErrorOf'] = (material) => {
  const watch = watches.get(material)
  if (!watch) return null
  if (watch.builds.length > 0) watch.builds = watch.builds.filter((build) => !inspect(build, watch))
  return watch.error
}

/** Checks a build, and sets `watch.error` if it failed. Returns false if the build is not complete. */
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
    // Error scopes resolve in order. When this scope resolves, three.js has set `error` of its pipelines. If the device is lost, the promise rejects.
    backend.device.pushErrorScope('validation')
    backend.device.popErrorScope().then(check, () => {})
  }
  return true
}

/** Whether the program of a pipeline failed to link. Only pipelines of the WebGL 2 backend have a program. */
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
  /** Undefined until the pipeline is compiled. */
  pipeline?: object
  /** Set if the GPU device rejects the pipeline. */
  error?: boolean
  programGPU?: WebGLProgram
}
