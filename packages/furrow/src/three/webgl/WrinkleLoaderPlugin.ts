import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { WrinkleLoader } from '../loader/wrinkle-loader.ts'
import type { WrinkleLoaderOptions } from '../options.ts'
import { Wrinkles } from './Wrinkles.ts'
import { watchDraws } from './watch-draws.ts'

/** `GLTFLoader` plugin for `WebGLRenderer`: `loader.register((parser) => new WrinkleLoaderPlugin(parser))`. */
export class WrinkleLoaderPlugin extends WrinkleLoader {
  /**
   * @param options options of the wrinkles of all faces, and `auto`, which generates wrinkles for files without wrinkles.
   * @throws FurrowError if an option is unknown or out of range.
   */
  constructor(parser: GLTFParser, options: WrinkleLoaderOptions = {}) {
    super(parser, { Wrinkles, watchDraws }, options)
  }
}
