import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { WrinkleLoader } from '../loader/wrinkle-loader.ts'
import { BINDINGS } from './bindings.ts'
import { Wrinkles } from './webgpu-wrinkles.ts'

/** For `GLTFLoader` and `WebGPURenderer`: `loader.register((parser) => new WrinkleLoaderPlugin(parser))`. */
export class WrinkleLoaderPlugin extends WrinkleLoader {
  constructor(parser: GLTFParser) {
    super(parser, Wrinkles, BINDINGS)
  }
}
