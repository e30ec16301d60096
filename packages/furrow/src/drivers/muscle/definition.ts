import { LARGEST } from '../../core/limits.ts'
import { IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/**
 * A virtual muscle (Waters 1987): it pulls the skin in its zone as a morph target of its name, whose weight is its contraction, and
 * activates its area by that. Positions are metres in the space of the mesh at rest.
 */
export interface MuscleDriver {
  type: 'muscle'
  name: string
  /** Absent: it moves the skin alone. */
  area?: string
  /** `linear`: a cone that converges on its origin; `sheet`: parallel fibres; `sphincter`: an ellipse that closes on its centre. */
  kind: 'linear' | 'sheet' | 'sphincter'
  /** Where it is attached; a sphincter's centre. */
  origin: [number, number, number]
  /** Where it ends in the skin; the end of a sphincter's semi-axis. */
  insertion: [number, number, number]
  /** Of a linear muscle: radians from its axis to the edge of its zone. */
  angle: number
  /** Metres: half a sheet's width, or a sphincter's other semi-axis. */
  width: number
  /** Where the pull is strongest and where it ends, as fractions of the distance from origin to insertion. */
  inner: number
  outer: number
  /** Fraction of the way to the origin that skin goes at full contraction. */
  strength: number
}

export const muscle: DriverDefinition<MuscleDriver> = {
  type: 'muscle',
  read: (fields) => ({
    name: fields.name('name'),
    ...(fields.has('area') && { area: fields.area() }),
    kind: fields.choice('kind', ['linear', 'sheet', 'sphincter'], 'linear'),
    ...fields.muscleAxis(),
    angle: fields.number('angle', 0.001, 1.57, 0.5),
    width: fields.number('width', 0.0001, LARGEST, 0.01),
    ...fields.zone(),
    strength: fields.number('strength', -1, 1, 0.3),
  }),
  describe: ({ name, area, kind }) => `${area ? `${area} = ` : ''}contraction of the ${kind} muscle ${name}`,
  activate: ({ name, area }) =>
    area === undefined
      ? undefined
      : { area, links: linkTo({ kind: 'target', name }), rule: 'sum', curve: IDENTITY },
}
