import { DEFAULT_AREA_SIZE } from '../core/limits.ts'

/**
 * `default` mixes normals and lights once; `paper` lights twice and mixes colours; `composed` writes the normals into a map
 * that the material then shows as its own; `off` shows none.
 */
export type WrinkleMode = 'default' | 'paper' | 'composed' | 'off'

export interface WrinklesOptions {
  /** `default` unless told. */
  mode?: WrinkleMode
  /** Side of the common grid of the areas in texels, 128 unless told. */
  areaSize?: number
  /**
   * Size of the mesh on screen in pixels from which on wrinkles show in full. Below it they fade, and from half
   * of it on they cost nothing. 0 unless told: they never fade.
   */
  fadeBelow?: number
}

export const WRINKLES_DEFAULTS: Required<WrinklesOptions> = {
  mode: 'default',
  areaSize: DEFAULT_AREA_SIZE,
  fadeBelow: 0,
}
