import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by a custom input, such as stress, cold or loudness. */
export interface InputDriver {
  type: 'input'
  /** Name of the input, as in `wrinkles.inputs.set(name, value)`; 0 until it is set. */
  name: string
  /** Name of the area. */
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
