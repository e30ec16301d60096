import type { WrinkleDriver } from 'furrow'
import type { StudioDocument } from '../../../document/document.ts'
import { age } from './age.tsx'
import { area } from './area.tsx'
import { bone } from './bone.tsx'
import type { AreaDriverType, Drivable, DriverType } from './driver-type.ts'
import { expression } from './expression.tsx'
import { input } from './input.tsx'
import { morph } from './morph.tsx'
import { muscle } from './muscle.tsx'
import { tension } from './tension.tsx'
import { time } from './time.tsx'

/** Definitions of driver types, in the order of the menu. */
const TYPES = { morph, area, tension, bone, age, input, muscle, time, expression } satisfies {
  readonly [type in AreaDriverType]: unknown
}

/** Types that a driver of an area can have, in the order of the menu. */
export const AREA_DRIVER_TYPES = Object.keys(TYPES) as readonly AreaDriverType[]

/** Returns the definition of a driver type, or undefined if the type is unknown. */
export function driverTypeOf(type: string): DriverType<WrinkleDriver> | undefined {
  return (TYPES as unknown as Record<string, DriverType<WrinkleDriver>>)[type]
}

/** Creates a driver with defaults, or returns null if the face or the document has no suitable input. */
export function createDriver(
  type: AreaDriverType,
  area: string,
  document: StudioDocument,
  face: Drivable,
): WrinkleDriver | null {
  return TYPES[type].create(area, document, face)
}
