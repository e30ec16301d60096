import { MAX_NUMBER } from '../../core/limits.ts'
import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Driver that activates an area (a group of wrinkles) by the person's age, for permanent wrinkles. */
export interface AgeDriver {
  type: 'age'
  /** Name of the activated area. */
  area: string
  /** Points [years, activation]. */
  curve: Curve
  /** Age in years until the application sets the input `age`, -1000..1000; default 20. Only the first `age` driver's value counts. */
  initial?: number
}

/** Range of ages in years. `youngest` is the default age. */
export const AGES = { youngest: 20, oldest: 80 } as const

export const age: DriverDefinition<AgeDriver> = {
  type: 'age',
  read: (fields) => ({
    area: fields.area(),
    curve: fields.curve(),
    ...(fields.has('initial') && {
      initial: fields.number('initial', -MAX_NUMBER, MAX_NUMBER, AGES.youngest),
    }),
  }),
  activate: ({ area, curve, initial = AGES.youngest }) => ({
    area,
    links: linkTo({ kind: 'value', name: 'age', initial }),
    rule: 'sum',
    curve,
  }),
}
