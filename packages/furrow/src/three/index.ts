/**
 * Wrinkles for three.js with `WebGLRenderer`.
 *
 * @module furrow/three
 */

export * from './common.ts'
export { extendLoader } from './webgl/extend-loader.ts'
export { WrinkleLoaderPlugin } from './webgl/WrinkleLoaderPlugin.ts'
export { Wrinkles } from './webgl/Wrinkles.ts'
