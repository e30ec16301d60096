import type { WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'

/** Either of three.js's renderers. */
export type AnyRenderer = WebGLRenderer | WebGPURenderer
