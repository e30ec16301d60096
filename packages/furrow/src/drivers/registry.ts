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

/** The drivers of this version. */
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

/** Types of drivers of this version. */
export type DriverType = KnownDriver['type']

/** Drivers of one type. */
export type DriverOf<T extends DriverType> = Extract<KnownDriver, { type: T }>

/** A driver. Those of a type that this version does not know are kept as they are, so that files of later versions survive. */
export type WrinkleDriver = KnownDriver | { type: string; [field: string]: unknown }

/** The definition of every type, in the order of the specification. */
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

/** Types of drivers of this version, in the order of the specification. */
export const DRIVER_TYPES = Object.keys(DEFINITIONS) as readonly DriverType[]

const definitions = new Map(Object.entries(DEFINITIONS) as [string, DriverDefinition][])

/**
 * Registers a type of driver of the application's own, for all files that are read afterwards. Readers that do not know the type keep
 * such drivers and run the others.
 *
 * @throws FurrowError when the type exists already, or the definition has no type or does not read.
 */
export function registerDriver<D extends { type: string }>(definition: DriverDefinition<D>): void {
  if (!isObject(definition) || typeof definition.type !== 'string' || typeof definition.read !== 'function') {
    throw wrongArgument('registerDriver', 'definition', definition, 'an object with type and read')
  }
  if (definitions.has(definition.type)) {
    throw new FurrowError({
      who: 'registerDriver',
      problem: 'a driver of that type exists',
      value: definition.type,
      remedy: 'choose another name, and register it only once',
    })
  }
  definitions.set(definition.type, definition as unknown as DriverDefinition)
}

/** The definition of a type; undefined if it is neither of this version nor registered. */
export function definitionOf(type: string): DriverDefinition | undefined {
  return definitions.get(type)
}

/** Whether a driver's type is of this version or registered; others have no effect. */
export function isKnownDriver(driver: WrinkleDriver): boolean {
  return definitions.has(driver.type)
}
