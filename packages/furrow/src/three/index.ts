/**
 * Wrinkles for three.js and its `WebGLRenderer`.
 *
 * @module furrow/three
 */

export * from './common.ts'
export { WrinkleLoaderPlugin } from './webgl/WrinkleLoaderPlugin.ts'
export { Wrinkles } from './webgl/Wrinkles.ts'
