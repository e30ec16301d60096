import {
  registerGLTFExtension,
  unregisterGLTFExtension,
} from '@babylonjs/loaders/glTF/2.0/glTFLoaderExtensionRegistry.js'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { WrinkleMapsExtension } from './loader/wrinkle-maps-extension.ts'
import { checkLoaderOptions, type LoaderOptions } from './options.ts'
import { noteRegistered } from './registered.ts'

/**
 * Lets Babylon.js load the wrinkles of glTF files, from the next file on. A loaded face wrinkles by itself as its morph targets move, and
 * so does each copy of it, with activations of its own. Called again, its options replace those before.
 *
 * @throws FurrowError when an option is unknown or out of range.
 */
export function registerWrinkleMaps(options: LoaderOptions = {}): void {
  checkLoaderOptions(options, 'registerWrinkleMaps')
  noteRegistered()
  unregisterGLTFExtension(WRINKLE_MAPS)
  // For files that do not declare the extension too, so that these are told of.
  registerGLTFExtension(WRINKLE_MAPS, false, (loader) => new WrinkleMapsExtension(loader, options))
}
