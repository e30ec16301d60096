import type { DriverType as TypeName, WrinkleDriver } from 'furrow'
import type { FunctionComponent } from 'preact'
import type { StudioDocument } from '../../../document/document.ts'
import { freeName } from '../../../document/names.ts'
import type { FormProps } from '../context.ts'

/** Names of the types that an area may have: all but `conflict`, which has no area. */
export type AreaDriverType = Exclude<TypeName, 'conflict'>

/** How the studio shows and creates drivers of one type. */
export interface DriverType<Driver> {
  /** Name in an artist's words. */
  readonly label: string
  /** Names of what a driver reads, for its heading. */
  reads?(driver: Driver): string
  /** Creates a driver to begin with, which the form then changes; null if the face or the document has nothing that it could read. */
  create(area: string, document: StudioDocument, face: Drivable): WrinkleDriver | null
  /** Fields of a driver. */
  readonly Form: FunctionComponent<FormProps<Driver>>
}

/** Parts of the face that a new driver may read. */
export interface Drivable {
  /** Blendshapes that are set, or one that could be, with their weights, 0..1. */
  readonly pose: ReadonlyMap<string, number>
  readonly targets: readonly string[]
  /** Joints, parents first. */
  readonly joints: readonly (readonly [from: string, joint: string])[]
  /** Where a muscle of the area would be attached, in metres; null for an area without skin under it. */
  muscle(): { readonly origin: Vector; readonly insertion: Vector } | null
}

type Vector = readonly [number, number, number]

/** Creates a name that no driver of the document has. */
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
