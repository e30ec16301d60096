import { type AutoCharacterOptions, checkCharacterOptions } from '../auto/run-options.ts'
import { isObject, wrongArgument } from '../core/argument.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'
import { checkOptionNames } from '../core/nearest-name.ts'

/**
 * Shading mode of wrinkles:
 * - `default` mixes the normals of smooth and wrinkled skin, and computes the lighting once
 * - `paper` computes the lighting separately for smooth and for wrinkled skin, and mixes the two colours (the method of the paper, see
 *   docs/paper.md)
 * - `composed` renders the mixed normals into a texture that replaces the material's normal map
 * - `off` shows no wrinkles
 */
export type WrinkleMode = 'default' | 'paper' | 'composed' | 'off'

const MODES: readonly WrinkleMode[] = ['default', 'paper', 'composed', 'off']

/**
 * Determines when height maps displace the surface, so that wrinkles change outlines and shadows:
 * - `off` never
 * - `on` always
 * - `near` while an area is active and a millimetre of skin covers more than a pixel
 */
export type ReliefMode = 'off' | 'on' | 'near'

const RELIEF_MODES: readonly ReliefMode[] = ['off', 'on', 'near']

/** Options of `Wrinkles`; defaults are in `WRINKLES_DEFAULTS`. */
export interface WrinklesOptions {
  /** Shading mode, default `default`. */
  mode?: WrinkleMode
  /** Areas are resampled to a square with this edge length, texels, default 128. Areas in KTX 2 textures keep their size. */
  areaSize?: number
  /**
   * Diameter in pixels. Wrinkles start to fade out when the mesh's bounding sphere is smaller than this on screen. At half this diameter they
   * are invisible and not updated. Default 0: wrinkles never fade.
   */
  fadeBelow?: number
  /** Condition for height maps to displace the surface, default `near`. The first use of relief decodes height maps and splits triangles. */
  relief?: ReliefMode
}

/** Options of `WrinkleLoaderPlugin`. */
export interface WrinkleLoaderOptions extends WrinklesOptions {
  /**
   * For files without wrinkles, generates wrinkles from their blendshapes and joints, in a worker after loading. Off by default. See
   * docs/auto-in-the-page.md.
   */
  auto?: AutoCharacterOptions
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
 * @param who name of the caller, for errors.
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
  if (auto !== undefined) checkCharacterOptions(auto, `${who} auto`)
}
