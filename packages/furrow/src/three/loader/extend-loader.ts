import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { wrongArgument } from '../../core/argument.ts'
import { checkLoaderOptions, type WrinkleLoaderOptions } from '../options.ts'
import type { WrinkleLoader } from './wrinkle-loader.ts'

/** A `GLTFLoader`, three.js's or another package's. */
export interface ExtendableLoader {
  /** Adds a plugin, once for each function. */
  // biome-ignore lint/suspicious/noExplicitAny: each package has a parser type of its own
  register(plugin: (parser: any) => any): unknown
}

/** The `WrinkleLoaderPlugin` of a renderer. */
type PluginClass = new (parser: GLTFParser, options?: WrinkleLoaderOptions) => WrinkleLoader

/** Plugin and options of each extended loader. */
const extensions = new WeakMap<ExtendableLoader, { Plugin: PluginClass; options: WrinkleLoaderOptions }>()

/** Registers a renderer's plugin on a loader, or replaces the options of one that was registered before. */
export function extendWith<Loader extends ExtendableLoader>(
  Plugin: PluginClass,
  loader: Loader,
  options: WrinkleLoaderOptions,
): Loader {
  if (typeof loader?.register !== 'function') {
    const value = typeof loader === 'function' ? 'a class or function' : loader
    throw wrongArgument('extendLoader', 'a loader', value, 'a GLTFLoader of three.js, not its class')
  }
  checkLoaderOptions(options, 'extendLoader')
  const isExtended = extensions.has(loader)
  extensions.set(loader, { Plugin, options })
  // Hooks extend a loader that they share again and again: one plugin each would pile up.
  if (!isExtended) {
    loader.register((parser: GLTFParser) => {
      const own = extensions.get(loader)!
      return new own.Plugin(parser, own.options)
    })
  }
  return loader
}
