import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'

/** Activates an area by other areas: links to their activations, combined by the rule and passed through the curve. */
export interface AreaDriver {
  type: 'area'
  /** Name of the activated area. */
  area: string
  /** Areas to read. */
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
