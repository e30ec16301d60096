import { type ExtendableLoader, extendWith } from '../loader/extend-loader.ts'
import type { WrinkleLoaderOptions } from '../options.ts'
import { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'

/**
 * Registers `WrinkleLoaderPlugin` for `WebGLRenderer` on any `GLTFLoader`: `extendLoader(new GLTFLoader())`, or as an argument of a
 * framework's loader, such as `useGLTF(url, undefined, undefined, extendLoader)`. Called again, it replaces the options.
 *
 * @param options of the wrinkles of all faces, and `auto` for files without wrinkles.
 * @returns the loader.
 * @throws FurrowError when it is not a loader, or an option is unknown or out of range.
 */
export function extendLoader<Loader extends ExtendableLoader>(
  loader: Loader,
  options: WrinkleLoaderOptions = {},
): Loader {
  return extendWith(WrinkleLoaderPlugin, loader, options)
}
