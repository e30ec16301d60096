import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { WrinkleLoader } from '../three/loader/wrinkle-loader.ts'
import type { WrinkleLoaderOptions } from '../three/options.ts'

/** A `GLTFLoader`, three.js's or another package's. */
export interface ExtendableLoader {
  /** Adds a plugin, once for each function. */
  // biome-ignore lint/suspicious/noExplicitAny: each package has a parser type of its own
  register(plugin: (parser: any) => any): unknown
}

/** The `WrinkleLoaderPlugin` of a renderer. */
export type PluginClass = new (parser: GLTFParser, options?: WrinkleLoaderOptions) => WrinkleLoader

/** Makes `loaderExtension` for a renderer. */
export function loaderExtensions(Plugin: PluginClass) {
  return (options?: WrinkleLoaderOptions) => {
    // A loader registers one function once, however often a hook extends it.
    const plugin = (parser: GLTFParser) => new Plugin(parser, options)
    return (loader: ExtendableLoader): void => {
      loader.register(plugin)
    }
  }
}
