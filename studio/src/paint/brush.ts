import { FurrowError } from 'furrow'
import { smoothstep } from 'furrow/internal'
import type { Stamp } from './stamp.ts'

/** Brush modes. Fill acts only at the start of a stroke. */
export const BRUSH_MODES = ['add', 'remove', 'smooth', 'fill'] as const
export type BrushMode = (typeof BRUSH_MODES)[number]

/**
 * Settings of a brush. A brush stroke is a series of dabs (imprints of the brush). The coverage of a texel, 0..1, tells how far the stroke
 * has moved the texel's weight towards 255 or 0 (see `covered`). It starts at 0. Each dab has the target `opacity * falloff * pressure`. If the
 * target exceeds the coverage, the coverage moves by the fraction `flow` towards the target. A stroke that crosses itself therefore never
 * exceeds its opacity.
 */
export interface Brush extends DabShape {
  mode: BrushMode
}

/** Modes of a brush that sculpts heights. Flatten changes heights towards the mean height under the first dab. */
export const SCULPT_MODES = ['raise', 'lower', 'smooth', 'flatten'] as const
export type SculptMode = (typeof SCULPT_MODES)[number]

/** Settings of a brush that sculpts heights. Heights are in the unit of the image that it changes. */
export interface SculptBrush extends DabShape {
  mode: SculptMode
  /** Change of the height where the coverage is 1, in the modes `raise` and `lower`. */
  rise: number
  /** Maximum height above or below 0. */
  limit: number
}

/** Settings that all brushes share. */
export interface DabShape {
  /** Radius, millimetres. */
  radius: number
  /** Width of the soft edge as a fraction of the radius, 0..1. */
  softness: number
  /** Fraction of the difference between target and coverage that each dab adds to the coverage, above 0, up to 1. */
  flow: number
  /** Maximum coverage, 0..1. */
  opacity: number
  /** Whether to also paint the mirror image of the stroke. */
  mirror: boolean
  /** Image that shapes each dab. Dabs of a stroke then lie side by side. */
  stamp?: Stamp | undefined
}

export const BRUSH_DEFAULTS = {
  mode: 'add',
  radius: 6,
  softness: 0.7,
  flow: 0.4,
  opacity: 1,
  mirror: false,
} as const satisfies Brush

/** Minimum and maximum radius, millimetres: about the sizes of a pore and a head. */
export const BRUSH_RADII = [0.1, 150] as const

/** Factor by which a key press changes the radius. */
const SIZE_STEP = 1.15

/** Returns the next smaller or larger radius, millimetres. */
export function resized(radius: number, change: 'smaller' | 'larger'): number {
  const [least, most] = BRUSH_RADII
  return Math.min(Math.max(change === 'larger' ? radius * SIZE_STEP : radius / SIZE_STEP, least), most)
}

/** @throws FurrowError if a setting is out of range. */
export function checkBrush(brush: Brush | SculptBrush): void {
  const { mode, radius, softness, flow, opacity } = brush
  const modes: readonly string[] = 'rise' in brush ? SCULPT_MODES : BRUSH_MODES
  if (!modes.includes(mode)) throw rangeError('mode', mode, modes.join(', '))
  const [least, most] = BRUSH_RADII
  if (!(radius >= least && radius <= most)) throw rangeError('radius', radius, `${least} to ${most} mm`)
  if (!(softness >= 0 && softness <= 1)) throw rangeError('softness', softness, '0 to 1')
  if (!(flow > 0 && flow <= 1)) throw rangeError('flow', flow, 'above 0, up to 1')
  if (!(opacity >= 0 && opacity <= 1)) throw rangeError('opacity', opacity, '0 to 1')
}

function rangeError(setting: string, value: unknown, limit: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `the ${setting} of the brush is out of range`,
    value,
    limit,
    remedy: 'choose a value in this range',
  })
}

/** Returns the falloff at a distance from the brush's centre: 1 up to the soft edge, then smoothstep to 0 at the radius. */
export function falloff(distance: number, radius: number, softness: number): number {
  if (distance >= radius) return 0
  return softness === 0 ? 1 : 1 - smoothstep((distance / radius - 1 + softness) / softness)
}
