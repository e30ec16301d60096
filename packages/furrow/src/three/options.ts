import { type AutoRunOptions, checkRunOptions } from '../auto/run-options.ts'
import { isObject, wrongArgument } from '../core/argument.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'
import { checkOptionNames } from '../core/nearest-name.ts'

/**
 * Shading mode of wrinkles:
 * - `default` mixes normals and lights once
 * - `paper` lights twice and mixes colours
 * - `composed` renders the mixed normals into a texture that replaces the material's normal map
 * - `off` shows no wrinkles
 */
export type WrinkleMode = 'default' | 'paper' | 'composed' | 'off'

const MODES: readonly WrinkleMode[] = ['default', 'paper', 'composed', 'off']

/**
 * When the layers' heights displace the surface, so that wrinkles change outlines and shadows. `near` displaces while an area is active
 * and a millimetre covers more than a pixel.
 */
export type ReliefMode = 'off' | 'on' | 'near'

const RELIEF_MODES: readonly ReliefMode[] = ['off', 'on', 'near']

/** Options of `Wrinkles`; defaults are in `WRINKLES_DEFAULTS`. */
export interface WrinklesOptions {
  /** Shading mode, default `default`. */
  mode?: WrinkleMode
  /** Side of the square grid that areas are resampled to, texels, default 128. Areas in texture arrays keep their size. */
  areaSize?: number
  /**
   * Size of the mesh on screen, in pixels, below which wrinkles fade out. At half this size they are gone and cost nothing. Default 0:
   * never fade.
   */
  fadeBelow?: number
  /** When the layers' heights displace the surface, default `near`. Heights are decoded and triangles split on first use. */
  relief?: ReliefMode
}

/** Options of `WrinkleLoaderPlugin`. */
export interface WrinkleLoaderOptions extends WrinklesOptions {
  /**
   * Generates wrinkles from the blendshapes of files that have none, in a worker after loading. Off by default. See
   * docs/auto-in-the-page.md.
   */
  auto?: AutoRunOptions
}

/** Defaults of `WrinklesOptions`. */
export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
  fadeBelow: 0,
  relief: 'near',
}

/** @throws FurrowError if the mode is unknown. */
export function checkMode(mode: WrinkleMode, who = 'Wrinkles.mode'): void {
  if (!MODES.includes(mode)) throw wrongArgument(who, 'mode', mode, MODES.join(', '))
}

/** @throws FurrowError if the relief mode is unknown. */
export function checkReliefMode(relief: ReliefMode, who = 'Wrinkles.relief'): void {
  if (!RELIEF_MODES.includes(relief)) throw wrongArgument(who, 'relief', relief, RELIEF_MODES.join(', '))
}

/**
 * @param who names the caller in errors.
 * @throws FurrowError if an option is unknown or out of range.
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

/** @throws FurrowError if an option, or an option of `auto`, is unknown or out of range. */
export function checkLoaderOptions(options: WrinkleLoaderOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object')
  checkOptionNames(options, [...Object.keys(WRINKLES_DEFAULTS), 'auto'], who)
  const { auto, ...others } = options
  checkOptions({ ...WRINKLES_DEFAULTS, ...others }, who)
  if (auto !== undefined) checkRunOptions(auto, `${who} auto`)
}
