import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Driver that activates an area (a group of wrinkles) by a number that the application sets, such as stress, cold or loudness. */
export interface InputDriver {
  type: 'input'
  /** Name of the input. The application sets it with `wrinkles.inputs.set(name, value)`. The input is 0 until it is set. */
  name: string
  /** Name of the activated area. */
  area: string
  /** Points [input, activation]. */
  curve: Curve
}

export const input: DriverDefinition<InputDriver> = {
  type: 'input',
  read: (fields) => ({ name: fields.name('name'), area: fields.area(), curve: fields.curve() }),
  activate: ({ name, area, curve }) => ({
    area,
    links: linkTo({ kind: 'value', name }),
    rule: 'sum',
    curve,
  }),
}
