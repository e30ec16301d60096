import { type ExtendableLoader, extendWith } from '../loader/extend-loader.ts'
import type { WrinkleLoaderOptions } from '../options.ts'
import { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'

/**
 * Registers `WrinkleLoaderPlugin` for `WebGLRenderer` on a `GLTFLoader`: `extendLoader(new GLTFLoader())`. Can be passed to drei:
 * `useGLTF(url, undefined, undefined, extendLoader)`. A second call with the same loader replaces the options.
 *
 * @param options options of the wrinkles of all faces, and `auto`, which generates wrinkles for files without wrinkles.
 * @returns the loader.
 * @throws FurrowError if `loader` is not a loader, or an option is unknown or out of range.
 */
export function extendLoader<Loader extends ExtendableLoader>(
  loader: Loader,
  options: WrinkleLoaderOptions = {},
): Loader {
  return extendWith(WrinkleLoaderPlugin, loader, options)
}
