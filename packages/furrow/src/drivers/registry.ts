import { isObject, wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import { type AgeDriver, age } from './age/definition.ts'
import { type AreaDriver, area } from './area/definition.ts'
import { type BoneDriver, bone } from './bone/definition.ts'
import { type ConflictDriver, conflict } from './conflict/definition.ts'
import type { DriverDefinition } from './definition.ts'
import { type ExpressionDriver, expression } from './expression/definition.ts'
import { type InputDriver, input } from './input/definition.ts'
import { type MorphDriver, morph } from './morph/definition.ts'
import { type MuscleDriver, muscle } from './muscle/definition.ts'
import { type TensionDriver, tension } from './tension/definition.ts'
import { type TimeDriver, time } from './time/definition.ts'

export type {
  AgeDriver,
  AreaDriver,
  BoneDriver,
  ConflictDriver,
  ExpressionDriver,
  InputDriver,
  MorphDriver,
  MuscleDriver,
  TensionDriver,
  TimeDriver,
}

/** A driver of one of the types that Furrow includes. */
export type KnownDriver =
  | MorphDriver
  | AreaDriver
  | ConflictDriver
  | BoneDriver
  | TensionDriver
  | MuscleDriver
  | AgeDriver
  | InputDriver
  | TimeDriver
  | ExpressionDriver

/** Name of a driver type that Furrow includes, e.g. `morph`. */
export type DriverType = KnownDriver['type']

/** Driver with the type name `T`. */
export type DriverOf<T extends DriverType> = Extract<KnownDriver, { type: T }>

/** A driver. Types that this version does not know are allowed, so that drivers of later versions are kept when a file is edited. */
export type WrinkleDriver = KnownDriver | { type: string; [field: string]: unknown }

/** Definitions of the built-in driver types, in the order of docs/FURROW_wrinkle_maps.md. */
const DEFINITIONS: { readonly [T in DriverType]: DriverDefinition<DriverOf<T>> } = {
  morph,
  area,
  conflict,
  bone,
  tension,
  muscle,
  age,
  input,
  time,
  expression,
}

/** Built-in driver types, in the order of docs/FURROW_wrinkle_maps.md. */
export const DRIVER_TYPES = Object.keys(DEFINITIONS) as readonly DriverType[]

const definitions = new Map(Object.entries(DEFINITIONS) as [string, DriverDefinition][])

/**
 * Registers a custom driver type for all files that are read afterwards. Applications that do not register the type ignore its drivers.
 *
 * @throws FurrowError if the type already exists, or the definition lacks `type` or `read`.
 */
export function registerDriver<D extends { type: string }>(definition: DriverDefinition<D>): void {
  if (!isObject(definition) || typeof definition.type !== 'string' || typeof definition.read !== 'function') {
    throw wrongArgument('registerDriver', 'definition', definition, 'an object with type and read')
  }
  if (definitions.has(definition.type)) {
    throw new FurrowError({
      who: 'registerDriver',
      problem: 'the driver type already exists',
      value: definition.type,
      remedy: 'choose another type name, and register each type only once',
    })
  }
  definitions.set(definition.type, definition as unknown as DriverDefinition)
}

/** Returns the definition of a driver type, or undefined if the type is neither built-in nor registered. */
export function definitionOf(type: string): DriverDefinition | undefined {
  return definitions.get(type)
}

/** Whether the type of a driver is built-in or registered. Other drivers have no effect. */
export function isKnownDriver(driver: WrinkleDriver): boolean {
  return definitions.has(driver.type)
}
