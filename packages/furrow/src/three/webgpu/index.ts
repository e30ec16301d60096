/**
 * Wrinkles for three.js and its `WebGPURenderer`, on WebGPU and on its WebGL 2 backend.
 *
 * @module furrow/webgpu
 */

export * from '../common.ts'
export { addDrivers } from './drivers.ts'
export { type Gradients, influenceFromMap, sampleSlice } from './influence.ts'
export { mixNormals, mixValues, reorient, type Shares } from './mix.ts'
export { RecomputedNormals } from './RecomputedNormals.ts'
export { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'
export { Wrinkles } from './webgpu-wrinkles.ts'
