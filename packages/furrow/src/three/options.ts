import { type AutoRunOptions, checkRunOptions } from '../auto/run-options.ts'
import { isObject, wrongArgument } from '../core/argument.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'
import { checkOptionNames } from '../core/nearest-name.ts'

/**
 * `default` mixes normals and lights once; `paper` lights twice and mixes colours; `composed` draws the mixed normals into a texture
 * that replaces the material's normal map; `off` shows no wrinkles.
 */
export type WrinkleMode = 'default' | 'paper' | 'composed' | 'off'

const MODES: readonly WrinkleMode[] = ['default', 'paper', 'composed', 'off']

/**
 * `on` moves the surface itself by the layers' heights, so that wrinkles change outlines and shadows; `near` does so where a millimetre
 * is more than a pixel and an area is active; `off` never does.
 */
export type ReliefMode = 'off' | 'on' | 'near'

const RELIEF_MODES: readonly ReliefMode[] = ['off', 'on', 'near']

/** How wrinkles are shown; defaults are in `WRINKLES_DEFAULTS`. */
export interface WrinklesOptions {
  /** `default` by default. */
  mode?: WrinkleMode
  /** Side of the square grid that areas are resampled to, in texels, 128 by default. Areas in texture arrays keep their size. */
  areaSize?: number
  /**
   * Size of the mesh on screen, in pixels, below which wrinkles fade; at half of it they are gone and cost nothing. 0 by default: they
   * never fade.
   */
  fadeBelow?: number
  /** Whether the layers' heights move the surface, `near` by default. Heights are decoded, and triangles split, when that is first wanted. */
  relief?: ReliefMode
}

/** Options of `WrinkleLoaderPlugin`. */
export interface WrinkleLoaderOptions extends WrinklesOptions {
  /**
   * Makes wrinkles for files that have none, from their blendshapes, in a worker after loading; none by default
   * (docs/auto-in-the-page.md).
   */
  auto?: AutoRunOptions
}

/** The defaults of `WrinklesOptions`. */
export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
  fadeBelow: 0,
  relief: 'near',
}

/** @throws FurrowError when there is no such mode. */
export function checkMode(mode: WrinkleMode, who = 'Wrinkles.mode'): void {
  if (!MODES.includes(mode)) throw wrongArgument(who, 'unknown mode', mode, MODES.join(', '))
}

/** @throws FurrowError when there is no such mode of relief. */
export function checkReliefMode(relief: ReliefMode, who = 'Wrinkles.relief'): void {
  if (!RELIEF_MODES.includes(relief))
    throw wrongArgument(who, 'unknown relief', relief, RELIEF_MODES.join(', '))
}

/**
 * @param who the caller, in errors.
 * @throws FurrowError at the first option that is not what it must be.
 */
export function checkOptions(options: Required<WrinklesOptions>, who: string): void {
  checkOptionNames(options, Object.keys(WRINKLES_DEFAULTS), who)
  const { mode, areaSize, fadeBelow, relief } = options
  checkMode(mode, who)
  checkReliefMode(relief, who)
  if (!(Number.isInteger(areaSize) && areaSize >= MIN_AREA_SIZE && areaSize <= MAX_IMAGE_SIDE)) {
    throw wrongArgument(who, 'areaSize', areaSize, `${MIN_AREA_SIZE} to ${MAX_IMAGE_SIDE} texels`)
  }
  if (!(fadeBelow >= 0 && fadeBelow < Infinity)) {
    throw wrongArgument(who, 'fadeBelow', fadeBelow, '0 pixels or more')
  }
}

/** @throws FurrowError as `checkOptions` does, or when an option of `auto` is unknown or out of range. */
export function checkLoaderOptions(options: WrinkleLoaderOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  checkOptionNames(options, [...Object.keys(WRINKLES_DEFAULTS), 'auto'], who)
  const { auto, ...others } = options
  checkOptions({ ...WRINKLES_DEFAULTS, ...others }, who)
  if (auto !== undefined) checkRunOptions(auto, `${who} auto`)
}
