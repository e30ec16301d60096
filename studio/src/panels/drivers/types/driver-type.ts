import type { DriverType as TypeName, WrinkleDriver } from 'furrow'
import type { FunctionComponent } from 'preact'
import type { StudioDocument } from '../../../document/document.ts'
import { freeName } from '../../../document/names.ts'
import type { Axis } from '../axes.ts'
import type { FormProps } from '../context.ts'

/** Types of drivers that activate an area. A driver of the type `conflict` has no area. */
export type AreaDriverType = Exclude<TypeName, 'conflict'>

export interface DriverType<Driver> {
  /** Displayed name of the type. */
  readonly label: string
  /** Returns the names of a driver's inputs, for its heading. */
  reads?(driver: Driver): string
  /** Returns the input axis of a driver's curve. Drivers without a curve lack this function. */
  axis?(driver: Driver): Axis
  /** Creates a driver with defaults, or returns null if the face or the document has no suitable input. */
  create(area: string, document: StudioDocument, face: Drivable): WrinkleDriver | null
  readonly Form: FunctionComponent<FormProps<Driver>>
}

/** Inputs of the face that new drivers can read. */
export interface Drivable {
  /** Blendshapes of the current pose with their weights, 0..1. Empty in the neutral pose. */
  readonly pose: ReadonlyMap<string, number>
  readonly targets: readonly string[]
  /** Each joint of the face with its parent (`from`). The list is sorted: parents come before their children. */
  readonly joints: readonly (readonly [from: string, joint: string])[]
  /** Returns both ends of a default muscle for the driver's area, in metres. Returns null if the area covers no vertex of the skin. */
  muscle(): { readonly origin: Vector; readonly insertion: Vector } | null
}

type Vector = readonly [number, number, number]

/** Returns a name that no driver of the document uses. */
export function freeDriverName({ drivers }: StudioDocument, wanted: string): string {
  return freeName(
    drivers.flatMap((driver) => ('name' in driver ? [{ name: String(driver.name) }] : [])),
    wanted,
  )
}

export function namesOf(links: readonly { name: string }[]): string {
  return links.map(({ name }) => name).join(', ')
}
