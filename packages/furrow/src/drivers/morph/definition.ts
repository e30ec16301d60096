import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'

/** Activates an area by blendshapes: links to their weights, combined by the rule and passed through the curve. */
export interface MorphDriver {
  type: 'morph'
  /** Name of the area. */
  area: string
  /** Blendshapes to read, in any spelling that `findTargets` knows. */
  targets: Link[]
  rule: Rule
  /** Outputs are activations, 0..1. */
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
  activate: ({ area, targets, rule, curve }) => ({ area, links: linksTo('target', targets), rule, curve }),
}
