import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by the strain of the skin under it, whatever deforms the mesh. */
export interface TensionDriver {
  type: 'tension'
  /** Name of the area. */
  area: string
  /** Measured strain: fraction by which the skin is shortened (`compression`) or lengthened (`stretch`). */
  measure: 'compression' | 'stretch'
  /** Direction of measurement in texture coordinates, across the wrinkles (Nordenberg 2003); default: the principal direction. */
  direction?: [u: number, v: number]
  /** Points [fraction, activation]. */
  curve: Curve
}

export const tension: DriverDefinition<TensionDriver> = {
  type: 'tension',
  read: (fields) => ({
    area: fields.area(),
    measure: fields.choice('measure', ['compression', 'stretch'], 'compression'),
    ...fields.direction(),
    curve: fields.curve(),
  }),
  activate: ({ area, measure, direction, curve }) => ({
    area,
    links: linkTo({ kind: 'tension', area, measure, ...(direction && { direction }) }),
    rule: 'sum',
    curve,
  }),
}
