import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Driver that activates an area (a group of wrinkles) by the strain of its skin. Blendshapes, joints or other deformations cause strain. */
export interface TensionDriver {
  type: 'tension'
  /** Name of the activated area. */
  area: string
  /** Measured strain: the fraction of its rest length by which the skin is shortened (`compression`) or lengthened (`stretch`). */
  measure: 'compression' | 'stretch'
  /** Direction of measurement in texture coordinates, across the wrinkles (Nordenberg 2003). Default: principal direction of the strain. */
  direction?: [u: number, v: number]
  /** Points [strain, activation]. */
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
