import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { wrongArgument } from '../../core/argument.ts'
import { checkLoaderOptions, type WrinkleLoaderOptions } from '../options.ts'
import type { WrinkleLoader } from './wrinkle-loader.ts'

/** A `GLTFLoader`, from three.js or another package. */
export interface ExtendableLoader {
  /** Registers a plugin; ignores a function that is already registered. */
  // biome-ignore lint/suspicious/noExplicitAny: each package has its own parser type
  register(plugin: (parser: any) => any): unknown
}

type PluginClass = new (parser: GLTFParser, options?: WrinkleLoaderOptions) => WrinkleLoader

const extensions = new WeakMap<ExtendableLoader, { Plugin: PluginClass; options: WrinkleLoaderOptions }>()

/** Registers a plugin on a loader, or replaces the options if the loader is already extended. */
export function extendWith<Loader extends ExtendableLoader>(
  Plugin: PluginClass,
  loader: Loader,
  options: WrinkleLoaderOptions,
): Loader {
  if (typeof loader?.register !== 'function') {
    const value = typeof loader === 'function' ? 'a class or function' : loader
    throw wrongArgument('extendLoader', 'loader', value, 'a GLTFLoader instance')
  }
  checkLoaderOptions(options, 'extendLoader')
  const isExtended = extensions.has(loader)
  extensions.set(loader, { Plugin, options })
  // React hooks call this repeatedly with the same loader, which must get only one plugin.
  if (!isExtended) {
    loader.register((parser: GLTFParser) => {
      const extension = extensions.get(loader)!
      return new extension.Plugin(parser, extension.options)
    })
  }
  return loader
}
