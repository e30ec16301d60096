import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { addDrivers } from '../three/drivers.ts'
import { WrinkleLoader } from '../three/wrinkle-loader.ts'
import { Wrinkles } from './Wrinkles.ts'

/** For `GLTFLoader` and `WebGLRenderer`: `loader.register((parser) => new WrinkleLoaderPlugin(parser))`. */
export class WrinkleLoaderPlugin extends WrinkleLoader {
  constructor(parser: GLTFParser) {
    super(parser, Wrinkles, addDrivers)
  }
}
