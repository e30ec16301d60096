import type { Driver } from '../../drivers/driver.ts'
import type { DriverType, WrinkleDriver } from '../../drivers/types.ts'
import type { VrmExpressions } from '../../drivers/vrm.ts'
import type { AnyRenderer } from '../atlas/influence-atlas.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

/** A driver and what it reads of a mesh. */
export interface Source {
  driver: Driver
  /** Brings the driver up to date with one face of the mesh, before this renderer draws it. */
  update(instance: number, renderer: AnyRenderer): void
}

export interface DriversOptions {
  /** A VRM's expressions (`vrm.expressionManager` of three-vrm): links may name them as well as blendshapes. */
  expressions?: VrmExpressions
}

/** How drivers of one type are bound to a mesh. */
export interface SourceType {
  /** Types of drivers that it plays. */
  types: readonly DriverType[]
  /** @param drivers of all types. */
  create(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[], options: DriversOptions): Source
}
