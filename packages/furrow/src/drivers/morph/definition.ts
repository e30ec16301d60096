import type { Rule } from '../activation.ts'
import { type Curve, IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { type Link, linksTo } from '../link.ts'

/**
 * Driver that activates an area (a group of wrinkles) by blendshape weights. The rule combines the links to one number, and the curve
 * converts this number to the activation.
 */
export interface MorphDriver {
  type: 'morph'
  /** Name of the activated area. */
  area: string
  /** Links to the blendshapes that the driver reads. Names may have any spelling that `findTargets` knows. */
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
