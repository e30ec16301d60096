/**
 * Wrinkles for three.js and its `WebGPURenderer`, on WebGPU and on its WebGL 2 backend.
 *
 * @module furrow/webgpu
 */

export * from '../common.ts'
export type { ArrayTexture } from '../material/array-texture.ts'
export { extendLoader } from './extend-loader.ts'
export { reorient } from './mixing/mix-normals.ts'
export { RecomputedNormals } from './RecomputedNormals.ts'
export { type Gradients, sampleSlice } from './texture-sampling.ts'
export { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'
export { Wrinkles } from './Wrinkles.ts'
