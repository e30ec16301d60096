import type { DriverDefinition } from '../definition.ts'

/** Facial expression that a file stores as a driver. It has no effect until an `ExpressionPlayer` plays it. */
export interface ExpressionDriver {
  type: 'expression'
  /** Name of the expression. */
  name: string
  /** Blendshape weights by name. Blendshapes that are not listed have weight 0. */
  targets: { name: string; weight: number }[]
  /** Activations, 0..1, of areas that have no other driver. */
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
  describe: ({ name, targets, activations }) => {
    const parts = [
      ...targets.map(({ name, weight }) => times(weight, name)),
      ...activations.map(({ area, activation }) => times(activation, `area ${area}`)),
    ]
    return `expression ${name}: ${parts.join(', ') || 'the face at rest'}`
  },
}

const times = (factor: number, name: string) => (factor === 1 ? name : `${factor} ${name}`)
