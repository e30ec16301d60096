import { FurrowError } from 'furrow'

/** Fill acts once, where a stroke begins. */
export const BRUSH_MODES = ['add', 'remove', 'smooth', 'fill'] as const
export type BrushMode = (typeof BRUSH_MODES)[number]

/**
 * What a stroke paints with. A dab gives each texel a target, `opacity` times the falloff there times the pen's pressure, and the stroke's
 * coverage rises towards it by `flow` of what is missing. So a stroke never covers more than its opacity, however often it crosses
 * itself, and at full flow it is as soft as one dab.
 */
export interface Brush {
  mode: BrushMode
  /** In millimetres. */
  radius: number
  /** Fraction of the radius across which it fades out, 0..1. */
  softness: number
  /** 0..1. */
  flow: number
  /** 0..1. */
  opacity: number
  /** Whether the other side of the face is painted as well. */
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

/** Least and greatest radius in millimetres: a pore, and a head. */
export const BRUSH_RADII = [0.1, 150] as const

/** @throws FurrowError that names the setting. */
export function checkBrush({ mode, radius, softness, flow, opacity }: Brush): void {
  if (!BRUSH_MODES.includes(mode)) throw wrong('mode', mode, BRUSH_MODES.join(', '))
  const [least, most] = BRUSH_RADII
  if (!(radius >= least && radius <= most)) throw wrong('radius', radius, `${least} to ${most} mm`)
  if (!(softness >= 0 && softness <= 1)) throw wrong('softness', softness, '0 to 1')
  if (!(flow > 0 && flow <= 1)) throw wrong('flow', flow, 'above 0, up to 1')
  if (!(opacity >= 0 && opacity <= 1)) throw wrong('opacity', opacity, '0 to 1')
}

function wrong(setting: string, value: unknown, limit: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `${setting} of the brush out of range`,
    value,
    limit,
    remedy: 'choose one in this range',
  })
}

/** How fully a brush covers at a distance from its centre, 0..1: by smoothstep from 1 where its softness begins to 0 at its radius. */
export function falloff(distance: number, radius: number, softness: number): number {
  if (distance >= radius) return 0
  return softness === 0 ? 1 : fade((distance / radius - 1 + softness) / softness)
}

/** 1 - smoothstep: from 1 at 0 to 0 at 1. */
export function fade(t: number): number {
  const x = Math.min(Math.max(t, 0), 1)
  return 1 - x * x * (3 - 2 * x)
}
