import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'
import { curveText } from '../text.ts'

/** Activates an area by what happens to the skin under it, whatever deforms the mesh. */
export interface TensionDriver {
  type: 'tension'
  area: string
  /** `compression`: fraction by which skin is shortened where it is shortened most; `stretch`: by which it is lengthened. */
  measure: 'compression' | 'stretch'
  curve: Curve
}

export const tension: DriverDefinition<TensionDriver> = {
  type: 'tension',
  read: (fields) => ({
    area: fields.area(),
    measure: fields.choice('measure', ['compression', 'stretch'], 'compression'),
    curve: fields.curve(),
  }),
  describe: ({ area, measure, curve }) => `${area} = ${measure} of its skin${curveText(curve)}`,
  activate: ({ area, measure, curve }) => ({
    area,
    links: linkTo({ kind: 'tension', area, measure }),
    rule: 'sum',
    curve,
  }),
}
