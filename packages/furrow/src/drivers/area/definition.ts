import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'
import { curveText, linksText } from '../text.ts'

/** Activates an area by other areas: its links to their activations, combined by the rule, through the curve. */
export interface AreaDriver {
  type: 'area'
  area: string
  areas: Link[]
  rule: Rule
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
  describe: ({ area, areas, rule, curve }) =>
    `${area} = ${linksText(areas, rule)} (areas)${curveText(curve)}`,
  activate: ({ area, areas, rule, curve }) => ({ area, links: linksTo('area', areas), rule, curve }),
}
