import type { Material } from 'three'
import { Fn } from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import type { RendererParts } from '../../material/renderer-parts.ts'

/** What becomes of a material's shaders. */
interface Watch {
  /** Those that nothing is known of yet. */
  builds: Build[]
  fault: string | null
}

/** A shader, built while the material is drawn, or bit by bit between frames (`compileAsync`). */
interface Build {
  builder: Builder
  isImmediate: boolean
}

const watches = new WeakMap<Material, Watch>()

/**
 * Passes a node on, and notes each shader that it is built into for `faultOf`: three.js tells of a shader that fails on the console
 * only, and draws nothing.
 */
export function watched(material: Material, node: Node<'vec3'>): Node<'vec3'> {
  const watch: Watch = watches.get(material) ?? { builds: [], fault: null }
  watches.set(material, watch)
  return Fn((_: [], nodeBuilder: NodeBuilder) => {
    const builder = nodeBuilder as Builder
    const { _currentRenderContext, _precompilationState } = builder.renderer
    watch.builds.push({ builder, isImmediate: Boolean(_currentRenderContext) && !_precompilationState })
    return node
  })()
}

/** Forgets a material. */
export function unwatch(material: Material): void {
  watches.delete(material)
}

/** On WebGPU the device answers a few frames later. */
export const faultOf: RendererParts['faultOf'] = (material) => {
  const watch = watches.get(material)
  if (!watch) return null
  if (watch.builds.length > 0) watch.builds = watch.builds.filter((build) => !inspect(build, watch))
  return watch.fault
}

/** Looks for a fault of a shader. Returns false if it is too early to tell. */
function inspect({ builder, isImmediate }: Build, watch: Watch): boolean {
  const { fragmentShader, renderer } = builder
  if (fragmentShader === null) {
    if (isImmediate) watch.fault = 'nodes that cannot be built'
    return isImmediate
  }
  const { backend } = renderer
  const pipelines = [...(renderer._pipelines?.caches.values() ?? [])]
    .filter(({ fragmentProgram }) => fragmentProgram?.code === fragmentShader)
    .map((pipeline) => backend.get(pipeline))
  if (pipelines.some(({ pipeline, error }) => !pipeline && !error)) return false
  const check = () => {
    if (pipelines.some((own) => own.error || isUnlinked(own, backend))) watch.fault = 'an invalid pipeline'
  }
  if (!backend.device) check()
  else {
    // It answers in order: after this, three.js knows whether its pipelines are valid. A lost device does not answer.
    backend.device.pushErrorScope('validation')
    backend.device.popErrorScope().then(check, () => {})
  }
  return true
}

/** On the WebGL 2 backend a pipeline is a program. */
function isUnlinked({ programGPU }: PipelineData, { gl }: Builder['renderer']['backend']): boolean {
  if (!gl || !programGPU || gl.isContextLost()) return false
  return gl.getProgramParameter(programGPU, gl.LINK_STATUS) === false
}

/** A builder, with what three.js does not document of it and of its renderer. */
type Builder = NodeBuilder & {
  /** Null until it is complete. */
  fragmentShader: string | null
  renderer: {
    /** In `render`. */
    _currentRenderContext: object | null
    /** In `compileAsync`, from r187 on. */
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
  /** Undefined until it is compiled. */
  pipeline?: object
  /** Set when the device has found it invalid. */
  error?: boolean
  programGPU?: WebGLProgram
}
