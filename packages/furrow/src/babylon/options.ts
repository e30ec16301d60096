import { isObject, wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'
import { didYouMean } from '../core/nearest-name.ts'

/** Shading mode. `default` mixes wrinkles into the maps of the material before lighting. `off` draws no wrinkles. */
export type WrinkleMode = 'default' | 'off'

/** Options of `Wrinkles`. `WRINKLES_DEFAULTS` contains the defaults. */
export interface WrinklesOptions {
  /** Shading mode, default `default`. */
  mode?: WrinkleMode
  /** Width and height to which areas are resampled, in texels; default 128. */
  areaSize?: number
}

/** Options of `registerWrinkleMaps`. */
export interface LoaderOptions extends WrinklesOptions {
  /**
   * URL of the folder with `basis_transcoder.js` and `basis_transcoder.wasm`, which are fetched when a file has KTX 2 maps. Without this
   * option, faces with KTX 2 maps are loaded without wrinkles.
   */
  transcoderPath?: string
}

/** Defaults of `WrinklesOptions`. */
export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
}

/** @throws FurrowError if Babylon.js does not support the mode. */
export function checkMode(mode: WrinkleMode, who = 'Wrinkles.mode'): void {
  if (mode === 'default' || mode === 'off') return
  throw wrongArgument(who, 'mode for Babylon.js', mode, 'default, off')
}

/**
 * Fills in defaults.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError if an option is unknown, is out of range, or is only supported in three.js.
 */
export function checkOptions(options: WrinklesOptions, who: string): Required<WrinklesOptions> {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  const known = Object.keys(WRINKLES_DEFAULTS)
  const unknown = Object.keys(options).find((name) => !known.includes(name))
  if (unknown) {
    throw new FurrowError({
      code: 'unsupported',
      who,
      problem: 'option unsupported in Babylon.js',
      value: unknown,
      limit: known.join(', '),
      remedy: didYouMean(
        unknown,
        known,
        'remove the option; docs/babylon.md lists the features that Babylon.js lacks',
      ),
    })
  }
  const { mode, areaSize } = { ...WRINKLES_DEFAULTS, ...options }
  checkMode(mode, who)
  if (!(Number.isInteger(areaSize) && areaSize >= MIN_AREA_SIZE && areaSize <= MAX_IMAGE_SIDE)) {
    throw wrongArgument(who, 'areaSize', areaSize, `${MIN_AREA_SIZE} to ${MAX_IMAGE_SIDE} texels`)
  }
  return { mode, areaSize }
}

/** @throws FurrowError if `checkOptions` throws, or if `transcoderPath` is not a string. */
export function checkLoaderOptions(options: LoaderOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  const { transcoderPath, ...others } = options
  if (transcoderPath !== undefined && typeof transcoderPath !== 'string') {
    throw wrongArgument(who, 'transcoderPath', transcoderPath, 'the address of a folder')
  }
  checkOptions(others, who)
}
