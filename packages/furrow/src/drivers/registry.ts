import { FurrowError } from '../core/error.ts'
import { age } from './age/definition.ts'
import { area } from './area/definition.ts'
import { bone } from './bone/definition.ts'
import { conflict } from './conflict/definition.ts'
import type { DriverDefinition } from './definition.ts'
import { expression } from './expression/definition.ts'
import { input } from './input/definition.ts'
import { morph } from './morph/definition.ts'
import { muscle } from './muscle/definition.ts'
import { tension } from './tension/definition.ts'
import { time } from './time/definition.ts'

export type { AgeDriver } from './age/definition.ts'
export type { AreaDriver } from './area/definition.ts'
export type { BoneDriver } from './bone/definition.ts'
export type { ConflictDriver } from './conflict/definition.ts'
export type { ExpressionDriver } from './expression/definition.ts'
export type { InputDriver } from './input/definition.ts'
export type { MorphDriver } from './morph/definition.ts'
export type { MuscleDriver } from './muscle/definition.ts'
export type { TensionDriver } from './tension/definition.ts'
export type { TimeDriver } from './time/definition.ts'

/** Every type of driver of this version, in the order of the specification. */
const DEFINITIONS = { morph, area, conflict, bone, tension, muscle, age, input, time, expression } as const

type Definitions = typeof DEFINITIONS

export type DriverType = keyof Definitions

/** A driver of one type. */
export type DriverOf<T extends DriverType> = Definitions[T] extends DriverDefinition<infer D> ? D : never

/** A driver. Types that this version does not know are kept as they are, so that a later version's file survives. */
export type WrinkleDriver = DriverOf<DriverType> | { type: string; [field: string]: unknown }

/** Names of the types of this version. */
export const DRIVER_TYPES = Object.keys(DEFINITIONS) as readonly DriverType[]

const definitions = new Map<string, DriverDefinition>(Object.entries(DEFINITIONS))

/**
 * Adds a type of driver of the application's own, for all faces that are read afterwards. Files may carry drivers of it;
 * readers that do not know the type keep them and play the others.
 *
 * @throws FurrowError when the type exists.
 */
export function registerDriver<D extends { type: string }>(definition: DriverDefinition<D>): void {
  if (definitions.has(definition.type)) {
    throw new FurrowError({
      who: 'registerDriver',
      what: 'a driver of that type exists',
      value: definition.type,
      remedy: 'choose another name for the type, and register it once',
    })
  }
  definitions.set(definition.type, definition as unknown as DriverDefinition)
}

/** The definition of a type; undefined where neither this version nor the application has one. */
export function definitionOf(type: string): DriverDefinition | undefined {
  return definitions.get(type)
}

/** Whether a driver has any effect here: its type is of this version or registered. */
export function isKnownDriver(driver: WrinkleDriver): boolean {
  return definitions.has(driver.type)
}

/** The drivers of one type, in their order. */
export function driversOf<T extends DriverType>(type: T, drivers: readonly WrinkleDriver[]): DriverOf<T>[] {
  return drivers.filter((driver): driver is DriverOf<T> => driver.type === type)
}

/** A driver in one line: `brow = 0.5 browInnerUp + browDown, curve (0, 0) (1, 1)`. */
export function describeDriver(driver: WrinkleDriver): string {
  return definitionOf(driver.type)?.describe(driver) ?? `${driver.type}: unknown type, kept as it is`
}
