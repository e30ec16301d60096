import { MAX_NUMBER } from '../../core/limits.ts'
import { IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/**
 * A virtual muscle (Waters 1987). It adds a morph target of its name that pulls the skin in its zone. The target's weight is the
 * contraction and activates the area. Positions are in metres, in the space of the mesh at rest.
 */
export interface MuscleDriver {
  type: 'muscle'
  /** Name of the muscle and its morph target. */
  name: string
  /** Optional name of the area; without it, the muscle only moves the skin. */
  area?: string
  /** `linear`: cone that converges at the origin; `sheet`: parallel fibres; `sphincter`: ellipse that contracts to its centre. */
  kind: 'linear' | 'sheet' | 'sphincter'
  /** Attachment to the bone, or centre of a sphincter. */
  origin: [number, number, number]
  /** Attachment to the skin, or end of a sphincter's semi-axis. */
  insertion: [number, number, number]
  /** Linear only: angle from the axis to the edge of the zone in radians, 0.001..1.57. */
  angle: number
  /** Half the width of a sheet, or the other semi-axis of a sphincter, metres. */
  width: number
  /** Distance of the strongest pull, as a fraction of the distance from origin to insertion. */
  inner: number
  /** Distance at which the pull ends, in the same unit; larger than `inner`. */
  outer: number
  /** Movement towards the origin at full contraction, as a fraction of the distance to the origin, -1..1. */
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
    width: fields.number('width', 0.0001, MAX_NUMBER, 0.01),
    ...fields.zone(),
    strength: fields.number('strength', -1, 1, 0.3),
  }),
  activate: ({ name, area }) =>
    area === undefined
      ? undefined
      : { area, links: linkTo({ kind: 'target', name }), rule: 'sum', curve: IDENTITY },
}
