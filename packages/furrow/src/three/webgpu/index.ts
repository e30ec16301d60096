/**
 * Wrinkles for three.js with `WebGPURenderer` (WebGPU or WebGL 2 backend).
 *
 * @module furrow/webgpu
 */

export * from '../common.ts'
export { extendLoader } from './extend-loader.ts'
export { RecomputedNormals } from './RecomputedNormals.ts'
export { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'
export { Wrinkles } from './Wrinkles.ts'
