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

/** Types in the order in which they are offered. */
const TYPES = { morph, area, tension, bone, age, input, muscle, time, expression } satisfies {
  readonly [type in AreaDriverType]: unknown
}

/** Names of the types that an area may have, in the order in which they are offered. */
export const AREA_DRIVER_TYPES = Object.keys(TYPES) as readonly AreaDriverType[]

/** How the studio shows drivers of a type; undefined for one that this version does not know. */
export function driverTypeOf(type: string): DriverType<WrinkleDriver> | undefined {
  return (TYPES as unknown as Record<string, DriverType<WrinkleDriver>>)[type]
}

/** Creates a driver to begin with; null if the face or the document has nothing that it could read. */
export function createDriver(
  type: AreaDriverType,
  area: string,
  document: StudioDocument,
  face: Drivable,
): WrinkleDriver | null {
  return TYPES[type].create(area, document, face)
}
