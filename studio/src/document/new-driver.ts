import type { Curve, DriverType, WrinkleDriver } from 'furrow'
import { AGES } from 'furrow/internal'
import type { StudioDocument } from './document.ts'
import { freeName } from './names.ts'

/** Types that an area may get: all but `conflict`, which has no area. */
export type AreaDriverType = Exclude<DriverType, 'conflict'>

/** What a new driver may read on the face. */
export interface Drivable {
  /** Blendshapes that are set, or one that could be, with their weights, 0..1. */
  readonly pose: ReadonlyMap<string, number>
  readonly targets: readonly string[]
  /** Joints, each after the one that it hangs on. */
  readonly joints: readonly (readonly [from: string, joint: string])[]
  /** Where a muscle of the area would be attached, in metres; null for an area without skin under it. */
  muscle(): { readonly origin: Vector; readonly insertion: Vector } | null
}

type Vector = readonly [number, number, number]

/**
 * A driver to begin with, which the form then changes.
 *
 * @returns null where the face or the document has nothing that it could read.
 */
export function newDriver(
  type: AreaDriverType,
  area: string,
  { areas, drivers }: StudioDocument,
  { pose, targets, joints, muscle }: Drivable,
): WrinkleDriver | null {
  const names = drivers.flatMap((driver) => ('name' in driver ? [{ name: String(driver.name) }] : []))
  switch (type) {
    case 'morph': {
      const [strongest] = [...pose].sort(([, a], [, b]) => b - a)
      const name = strongest?.[0] ?? targets[0]
      return name === undefined ? null : { type, area, targets: [{ name }] }
    }
    case 'area': {
      const other = areas.find(({ name }) => name !== area)
      return other ? { type, area, areas: [{ name: other.name }] } : null
    }
    case 'bone':
      return joints[0] ? { type, area, joints: joints[0], measure: 'angle', curve: BENT } : null
    case 'muscle': {
      const axis = muscle()
      return axis && { type, name: freeName(names, 'muscle'), area, ...axis }
    }
    case 'tension':
      return { type, area, measure: 'compression', curve: COMPRESSED }
    case 'age':
      return {
        type,
        area,
        curve: [
          [30, 0],
          [AGES.oldest, 1],
        ],
      }
    case 'input':
      return {
        type,
        area,
        name: freeName(names, 'stress'),
        curve: [
          [0, 0],
          [1, 1],
        ],
      }
    case 'time':
      return { type, area, attack: 0.1, release: 0.4 }
    case 'expression': {
      const set = [...pose].map(([name, weight]) => ({ name, weight }))
      return {
        type,
        name: freeName(names, 'expression'),
        targets: set,
        activations: [{ area, activation: 1 }],
      }
    }
  }
}

/** Radians: a joint that is bent by a right angle. */
const BENT: Curve = [
  [0, 0],
  [1.57, 1],
]

/** Fractions of its length by which skin is shortened where it creases. */
const COMPRESSED: Curve = [
  [0.03, 0],
  [0.2, 1],
]
