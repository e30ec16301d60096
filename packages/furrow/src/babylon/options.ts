import { isObject, wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'
import { didYouMean } from '../core/nearest-name.ts'

/** `default` mixes normals and lights once; `off` shows no wrinkles. */
export type WrinkleMode = 'default' | 'off'

/** How wrinkles are shown; defaults are in `WRINKLES_DEFAULTS`. */
export interface WrinklesOptions {
  /** `default` by default. */
  mode?: WrinkleMode
  /** Side of the square grid that areas are resampled to, in texels, 128 by default. */
  areaSize?: number
}

/** Options of `registerWrinkleMaps`. */
export interface LoaderOptions extends WrinklesOptions {
  /**
   * Folder of `basis_transcoder.js` and `basis_transcoder.wasm`, which files with KTX 2 need and are fetched with the first of them. None
   * by default: such a file then stays plain.
   */
  transcoderPath?: string
}

/** The defaults of `WrinklesOptions`. */
export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
}

/** @throws FurrowError when there is no such mode in Babylon.js. */
export function checkMode(mode: WrinkleMode, who = 'Wrinkles.mode'): void {
  if (mode === 'default' || mode === 'off') return
  throw wrongArgument(who, 'mode unsupported in Babylon.js', mode, 'default, off')
}

/**
 * @param who the caller, in errors.
 * @throws FurrowError at the first option that is not what it must be, or that only three.js has.
 */
export function checkOptions(options: WrinklesOptions, who: string): Required<WrinklesOptions> {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  const known = Object.keys(WRINKLES_DEFAULTS)
  const unknown = Object.keys(options).find((name) => !known.includes(name))
  if (unknown) {
    throw new FurrowError({
      code: 'unsupported',
      who,
      problem: 'an option that Babylon.js does not have',
      value: unknown,
      limit: known.join(', '),
      remedy: didYouMean(unknown, known, 'leave it out; docs/babylon.md lists what only three.js shows'),
    })
  }
  const { mode, areaSize } = { ...WRINKLES_DEFAULTS, ...options }
  checkMode(mode, who)
  if (!(Number.isInteger(areaSize) && areaSize >= MIN_AREA_SIZE && areaSize <= MAX_IMAGE_SIDE)) {
    throw wrongArgument(who, 'areaSize', areaSize, `${MIN_AREA_SIZE} to ${MAX_IMAGE_SIDE} texels`)
  }
  return { mode, areaSize }
}

/** @throws FurrowError as `checkOptions` does, or when `transcoderPath` is no text. */
export function checkLoaderOptions(options: LoaderOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  const { transcoderPath, ...others } = options
  if (transcoderPath !== undefined && typeof transcoderPath !== 'string') {
    throw wrongArgument(who, 'transcoderPath', transcoderPath, 'the address of a folder')
  }
  checkOptions(others, who)
}
