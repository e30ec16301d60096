import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by the strain of the skin under it, whatever deforms the mesh. */
export interface TensionDriver {
  type: 'tension'
  /** Name of the area. */
  area: string
  /** Fraction by which the skin is shortened, or lengthened, along its principal direction. */
  measure: 'compression' | 'stretch'
  /** Points [fraction, activation]. */
  curve: Curve
}

export const tension: DriverDefinition<TensionDriver> = {
  type: 'tension',
  read: (fields) => ({
    area: fields.area(),
    measure: fields.choice('measure', ['compression', 'stretch'], 'compression'),
    curve: fields.curve(),
  }),
  activate: ({ area, measure, curve }) => ({
    area,
    links: linkTo({ kind: 'tension', area, measure }),
    rule: 'sum',
    curve,
  }),
}
