import {
  registerGLTFExtension,
  unregisterGLTFExtension,
} from '@babylonjs/loaders/glTF/2.0/glTFLoaderExtensionRegistry.js'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { WrinkleMapsExtension } from './loader/wrinkle-maps-extension.ts'
import { checkLoaderOptions, type LoaderOptions } from './options.ts'
import { markRegistered } from './registered.ts'

/**
 * Registers the glTF extension FURROW_wrinkle_maps with Babylon.js. Faces in files that are loaded afterwards have wrinkles. The drivers of
 * a file activate the wrinkles by morph targets and other inputs. Each copy of a face has separate activations. Another call replaces the
 * options.
 *
 * @throws FurrowError if an option is unknown or out of range.
 */
export function registerWrinkleMaps(options: LoaderOptions = {}): void {
  checkLoaderOptions(options, 'registerWrinkleMaps')
  markRegistered()
  unregisterGLTFExtension(WRINKLE_MAPS)
  // The argument `false` makes Babylon.js use the extension for all files, even if `extensionsUsed` lacks it. Such files cause a warning.
  registerGLTFExtension(WRINKLE_MAPS, false, (loader) => new WrinkleMapsExtension(loader, options))
}
