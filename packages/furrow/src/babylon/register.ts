import {
  registerGLTFExtension,
  unregisterGLTFExtension,
} from '@babylonjs/loaders/glTF/2.0/glTFLoaderExtensionRegistry.js'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { WrinkleMapsExtension } from './loader/wrinkle-maps-extension.ts'
import { checkLoaderOptions, type LoaderOptions } from './options.ts'
import { markRegistered } from './registered.ts'

/**
 * Registers FURROW_wrinkle_maps with Babylon.js's glTF loader, from the next file on. Wrinkles of loaded faces follow morph targets
 * automatically. Copies of a face get their own activations. Further calls replace the options.
 *
 * @throws FurrowError if an option is unknown or out of range.
 */
export function registerWrinkleMaps(options: LoaderOptions = {}): void {
  checkLoaderOptions(options, 'registerWrinkleMaps')
  markRegistered()
  unregisterGLTFExtension(WRINKLE_MAPS)
  // Also for files that do not list the extension in `extensionsUsed`, so that they cause a warning.
  registerGLTFExtension(WRINKLE_MAPS, false, (loader) => new WrinkleMapsExtension(loader, options))
}
