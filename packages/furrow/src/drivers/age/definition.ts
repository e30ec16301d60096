import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'
import { curveText } from '../text.ts'

/** Activates an area by the person's age in years: wrinkles that stay. */
export interface AgeDriver {
  type: 'age'
  area: string
  /** Points [years, activation]. */
  curve: Curve
}

/** Years within which faces are drawn; a face is `youngest` until the application sets the input `age`. */
export const AGES = { youngest: 20, oldest: 80 } as const

export const age: DriverDefinition<AgeDriver> = {
  type: 'age',
  read: (fields) => ({ area: fields.area(), curve: fields.curve() }),
  describe: ({ area, curve }) => `${area} = age${curveText(curve)}`,
  activate: ({ area, curve }) => ({
    area,
    links: linkTo({ kind: 'value', name: 'age', initial: AGES.youngest }),
    rule: 'sum',
    curve,
  }),
}
