import { LARGEST } from '../../core/limits.ts'
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
  /** Years until the application sets the input, -1000..1000, 20 by default. Of several drivers the first counts. */
  initial?: number
}

/** Range of ages, in years, that wrinkles are drawn for. A face is `youngest` until the application sets the input `age`, unless its drivers say otherwise. */
export const AGES = { youngest: 20, oldest: 80 } as const

export const age: DriverDefinition<AgeDriver> = {
  type: 'age',
  read: (fields) => ({
    area: fields.area(),
    curve: fields.curve(),
    ...(fields.has('initial') && { initial: fields.number('initial', -LARGEST, LARGEST, AGES.youngest) }),
  }),
  activate: ({ area, curve, initial = AGES.youngest }) => ({
    area,
    links: linkTo({ kind: 'value', name: 'age', initial }),
    rule: 'sum',
    curve,
  }),
}
