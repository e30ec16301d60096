import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'
import { curveText, linksText } from '../text.ts'

/** Activates an area by blendshapes: its links to them combined by the rule, through the curve. */
export interface MorphDriver {
  type: 'morph'
  /** Name of the area. */
  area: string
  targets: Link[]
  rule: Rule
  curve: Curve
}

export const morph: DriverDefinition<MorphDriver> = {
  type: 'morph',
  read: (fields) => ({
    area: fields.area(),
    targets: fields.links('targets'),
    rule: fields.rule(),
    curve: fields.curve(IDENTITY),
  }),
  describe: ({ area, targets, rule, curve }) => `${area} = ${linksText(targets, rule)}${curveText(curve)}`,
  activate: ({ area, targets, rule, curve }) => ({ area, links: linksTo('target', targets), rule, curve }),
}
