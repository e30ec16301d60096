import type { WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'

/** One of three.js's two renderers. */
export type AnyRenderer = WebGLRenderer | WebGPURenderer
