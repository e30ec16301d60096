import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'

/**
 * Driver that activates an area (a group of wrinkles) by the activations of other areas. The rule combines the links to one number, and the
 * curve converts this number to the activation.
 */
export interface AreaDriver {
  type: 'area'
  /** Name of the activated area. */
  area: string
  /** Links to the areas that the driver reads. */
  areas: Link[]
  rule: Rule
  /** Outputs are activations, 0..1. */
  curve: Curve
}

export const area: DriverDefinition<AreaDriver> = {
  type: 'area',
  read: (fields) => ({
    area: fields.area(),
    areas: fields.links('areas', fields.areas),
    rule: fields.rule(),
    curve: fields.curve(IDENTITY),
  }),
  activate: ({ area, areas, rule, curve }) => ({ area, links: linksTo('area', areas), rule, curve }),
}
