import { FurrowError } from 'furrow'

/** Brush modes. Fill acts only at the start of a stroke. */
export const BRUSH_MODES = ['add', 'remove', 'smooth', 'fill'] as const
export type BrushMode = (typeof BRUSH_MODES)[number]

/**
 * Brush settings. A dab gives each texel a target: `opacity` times falloff times pen pressure. The coverage approaches the target by
 * the fraction `flow`, so that a stroke never exceeds its opacity where it crosses itself.
 */
export interface Brush {
  mode: BrushMode
  /** Radius, millimetres. */
  radius: number
  /** Width of the soft edge as a fraction of the radius, 0..1. */
  softness: number
  /** Fraction of the remaining coverage that a dab adds, above 0, up to 1. */
  flow: number
  /** Maximum coverage, 0..1. */
  opacity: number
  /** Whether to paint the other side of the face too. */
  mirror: boolean
}

export const BRUSH_DEFAULTS = {
  mode: 'add',
  radius: 6,
  softness: 0.7,
  flow: 0.4,
  opacity: 1,
  mirror: false,
} as const satisfies Brush

/** Minimum and maximum radius, millimetres: a pore and a head. */
export const BRUSH_RADII = [0.1, 150] as const

/** @throws FurrowError that names the invalid setting. */
export function checkBrush({ mode, radius, softness, flow, opacity }: Brush): void {
  if (!BRUSH_MODES.includes(mode)) throw rangeError('mode', mode, BRUSH_MODES.join(', '))
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
    problem: `${setting} of the brush out of range`,
    value,
    limit,
    remedy: 'choose one in this range',
  })
}

/** Returns the coverage at a distance from the centre, 0..1: 1 in the core, then smoothstep to 0 at the radius. */
export function falloff(distance: number, radius: number, softness: number): number {
  if (distance >= radius) return 0
  return softness === 0 ? 1 : fade((distance / radius - 1 + softness) / softness)
}

/** Returns 1 - smoothstep: from 1 at 0 to 0 at 1. */
export function fade(t: number): number {
  const x = Math.min(Math.max(t, 0), 1)
  return 1 - x * x * (3 - 2 * x)
}
