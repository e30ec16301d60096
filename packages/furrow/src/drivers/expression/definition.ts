import type { DriverDefinition } from '../definition.ts'

/** A preset of the file: blendshapes and activations by name. */
export interface ExpressionDriver {
  type: 'expression'
  name: string
  targets: { name: string; weight: number }[]
  /** For faces without other drivers. */
  activations: { area: string; activation: number }[]
}

export const expression: DriverDefinition<ExpressionDriver> = {
  type: 'expression',
  read: (fields) => ({
    name: fields.name('name'),
    targets: fields.list('targets', (item) => ({ name: item.name('name'), weight: item.weight() })),
    activations: fields.list('activations', (item) => ({
      area: item.area(),
      activation: item.number('activation', 0, 1, 1),
    })),
  }),
  describe: ({ name, targets, activations }) =>
    `expression ${name}: ${[
      ...targets.map(({ name, weight }) => `${name} ${weight}`),
      ...activations.map(({ area, activation }) => `area ${area} ${activation}`),
    ].join(', ')}`,
}
