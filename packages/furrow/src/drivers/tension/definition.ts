import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by the strain of the skin under it, whatever deforms the mesh. */
export interface TensionDriver {
  type: 'tension'
  /** Name of the area. */
  area: string
  /** Fraction by which the skin is shortened, or lengthened. */
  measure: 'compression' | 'stretch'
  /**
   * Direction in texture coordinates along which it is measured: wrinkles lie across it (Nordenberg 2003).
   * By default the principal one, wherever that points.
   */
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
