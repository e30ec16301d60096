import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by the person's age: wrinkles that stay. */
export interface AgeDriver {
  type: 'age'
  /** Name of the area. */
  area: string
  /** Points [years, activation]. */
  curve: Curve
}

/** Range of ages, in years, that wrinkles are drawn for. A face is `youngest` until the application sets the input `age`. */
export const AGES = { youngest: 20, oldest: 80 } as const

export const age: DriverDefinition<AgeDriver> = {
  type: 'age',
  read: (fields) => ({ area: fields.area(), curve: fields.curve() }),
  activate: ({ area, curve }) => ({
    area,
    links: linkTo({ kind: 'value', name: 'age', initial: AGES.youngest }),
    rule: 'sum',
    curve,
  }),
}
