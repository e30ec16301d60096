export * from '../three/index.ts'
export { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'
export { Wrinkles } from './Wrinkles.ts'
