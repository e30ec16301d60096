import type { DriverType as TypeName, WrinkleDriver } from 'furrow'
import type { FunctionComponent } from 'preact'
import type { StudioDocument } from '../../../document/document.ts'
import { freeName } from '../../../document/names.ts'
import type { FormProps } from '../context.ts'

/** Driver types of an area: all but `conflict`, which has no area. */
export type AreaDriverType = Exclude<TypeName, 'conflict'>

/** Label, factory and form of a driver type. */
export interface DriverType<Driver> {
  /** Label for artists. */
  readonly label: string
  /** Returns the names of a driver's inputs, for its heading. */
  reads?(driver: Driver): string
  /** Creates a driver with defaults, or returns null if the face or the document has no suitable input. */
  create(area: string, document: StudioDocument, face: Drivable): WrinkleDriver | null
  /** Form for a driver. */
  readonly Form: FunctionComponent<FormProps<Driver>>
}

/** Inputs of the face for new drivers. */
export interface Drivable {
  /** Set blendshapes, or a default one, with their weights, 0..1. */
  readonly pose: ReadonlyMap<string, number>
  readonly targets: readonly string[]
  /** Joints, parents first. */
  readonly joints: readonly (readonly [from: string, joint: string])[]
  /** Returns default attachments of a muscle for the area, metres, or null if no skin lies under the area. */
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

/** Joins the names of links. */
export function namesOf(links: readonly { name: string }[]): string {
  return links.map(({ name }) => name).join(', ')
}
