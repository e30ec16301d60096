import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { WrinkleLoader } from '../loader/wrinkle-loader.ts'
import { BINDINGS } from '../sources/bind-drivers.ts'
import { Wrinkles } from './webgl-wrinkles.ts'

/** For `GLTFLoader` and `WebGLRenderer`: `loader.register((parser) => new WrinkleLoaderPlugin(parser))`. */
export class WrinkleLoaderPlugin extends WrinkleLoader {
  constructor(parser: GLTFParser) {
    super(parser, Wrinkles, BINDINGS)
  }
}
