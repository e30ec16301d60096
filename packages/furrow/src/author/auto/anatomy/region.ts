import { bezierAt } from '../../../math/bezier.ts'
import { type Spot, unroll } from '../chart.ts'
import type { LineStyle, SkinRegion } from '../crease.ts'
import type { Landmarks, Place } from '../face.ts'
import type { Random } from '../random.ts'

/** Where a crease would run, if nothing but anatomy had a say. */
export interface Guide extends LineStyle {
  spots: readonly Spot[]
}

/** A part of the face. */
export interface Region extends SkinRegion {
  guides: readonly Guide[]
  /** Blendshapes that its lines are drawn for, where it shares them with others; else its cause. */
  together?: SkinRegion['cause']
}

/** What regions are made from. */
export interface Build {
  landmarks: Landmarks
  /** 0 at 20 years, 1 at 80. */
  age: number
  /** Numbers for one part of the face. */
  random(name: string): Random
}

/** 1 for the person's left, -1 for the right. */
export type Side = 1 | -1

/** Both, with the ends that ARKit's names have. */
export const SIDES = [
  [1, 'Left'],
  [-1, 'Right'],
] as const

/** A landmark on the unrolled face. */
export function spotOf([x, y, z]: Place): Spot {
  return unroll(x, y, z)
}

/** A line from age 20 to age 80. */
export function grown(age: number, young: number, old: number): number {
  return young + age * (old - young)
}

/** Spots along a curve, evenly by its parameter 0..1. */
export function curve(count: number, at: (t: number) => Spot): Spot[] {
  return Array.from({ length: count }, (_, i) => at(i / (count - 1)))
}

/** A cubic Bezier curve, mirrored to the side. */
export function bezier(side: Side, a: Spot, b: Spot, c: Spot, d: Spot): Spot[] {
  return curve(16, (t) => {
    const [across, up] = bezierAt(a, b, c, d, t)
    return [side * across, up]
  })
}
