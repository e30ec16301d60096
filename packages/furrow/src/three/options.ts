import { FurrowError } from '../core/error.ts'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE, MIN_AREA_SIZE } from '../core/limits.ts'

/**
 * `default` mixes normals and lights once; `paper` lights twice and mixes colours; `composed` draws the mixed normals into a texture
 * that replaces the material's normal map; `off` shows no wrinkles.
 */
export type WrinkleMode = 'default' | 'paper' | 'composed' | 'off'

const MODES: readonly WrinkleMode[] = ['default', 'paper', 'composed', 'off']

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
}

/** The defaults of `WrinklesOptions`. */
export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
  fadeBelow: 0,
}

/**
 * Checks options that a page passes on.
 *
 * @param who names the caller in errors.
 * @throws FurrowError at the first one that is unknown or out of range.
 */
export function checkOptions({ mode, areaSize, fadeBelow }: WrinklesOptions, who: string): void {
  const fail = (option: string, value: unknown, limit: string) => {
    const what = `the option ${option} is not possible`
    throw new FurrowError({
      code: 'out-of-range',
      who,
      what,
      value,
      limit,
      remedy: 'change it or leave it out',
    })
  }
  if (mode !== undefined && !MODES.includes(mode)) fail('mode', mode, MODES.join(', '))
  const isSize = Number.isInteger(areaSize) && areaSize! >= MIN_AREA_SIZE && areaSize! <= MAX_IMAGE_SIDE
  if (areaSize !== undefined && !isSize) {
    fail('areaSize', areaSize, `integers from ${MIN_AREA_SIZE} to ${MAX_IMAGE_SIDE} texels`)
  }
  if (fadeBelow !== undefined && !(Number.isFinite(fadeBelow) && fadeBelow >= 0)) {
    fail('fadeBelow', fadeBelow, 'pixels, 0 or more')
  }
}
