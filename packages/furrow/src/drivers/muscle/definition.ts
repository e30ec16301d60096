import { LARGEST } from '../../core/limits.ts'
import { IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/**
 * A virtual muscle (Waters 1987). It becomes a morph target of its name, which pulls the skin in its zone and whose weight is the
 * contraction; that activates its area. Positions are in metres, in the space of the mesh at rest.
 */
export interface MuscleDriver {
  type: 'muscle'
  /** Name of the muscle and its morph target. */
  name: string
  /** Name of the area; if absent, the muscle only moves the skin. */
  area?: string
  /** `linear`: a cone that converges at its origin; `sheet`: parallel fibres; `sphincter`: an ellipse that contracts to its centre. */
  kind: 'linear' | 'sheet' | 'sphincter'
  /** Where it is attached to the bone; a sphincter's centre. */
  origin: [number, number, number]
  /** Where it is attached to the skin; the end of a sphincter's semi-axis. */
  insertion: [number, number, number]
  /** Of a linear muscle: the angle from its axis to the edge of its zone, in radians, 0.001..1.57. */
  angle: number
  /** Half the width of a sheet, or a sphincter's other semi-axis, in metres. */
  width: number
  /** Where the pull is strongest, as a fraction of the distance from origin to insertion. */
  inner: number
  /** Where the pull ends, as the same fraction; more than `inner`. */
  outer: number
  /** How far skin moves towards the origin at full contraction, as a fraction of its distance, -1..1. */
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
  activate: ({ name, area }) =>
    area === undefined
      ? undefined
      : { area, links: linkTo({ kind: 'target', name }), rule: 'sum', curve: IDENTITY },
}
