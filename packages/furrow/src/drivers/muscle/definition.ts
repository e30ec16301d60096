import { MAX_NUMBER } from '../../core/limits.ts'
import { IDENTITY } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/**
 * A virtual muscle (Waters 1987). The muscle adds a morph target to the mesh. The morph target pulls the skin in the muscle's zone. The
 * weight of the morph target is the contraction of the muscle. This weight activates the area. Positions are in metres, in the space of the
 * mesh at rest.
 */
export interface MuscleDriver {
  type: 'muscle'
  /** Name of the muscle and of its morph target. */
  name: string
  /** Name of the activated area. Without an area, the muscle only moves the skin. */
  area?: string
  /**
   * Shape of the zone. `linear`: cone with its tip at the origin. `sheet`: cylinder of parallel fibres that starts at the origin.
   * `sphincter`: ellipsoid around the origin.
   */
  kind: 'linear' | 'sheet' | 'sphincter'
  /** Attachment of the muscle to the bone, or centre of a sphincter. */
  origin: [number, number, number]
  /** Attachment of the muscle to the skin, or end of the first semi-axis of a sphincter. */
  insertion: [number, number, number]
  /** Half the opening angle of a `linear` muscle's cone, in radians, 0.001..1.57. */
  angle: number
  /** Half the width of a sheet, or length of the second semi-axis of a sphincter, in metres. */
  width: number
  /**
   * Distance from the origin at which the pull is strongest, as a fraction of the muscle's length (from origin to insertion). In a sheet,
   * distances are measured along the fibres. In a sphincter, they are relative to the semi-axes, and the pull is constant up to `inner`.
   */
  inner: number
  /** Distance from the origin at which the pull ends, measured like `inner`. Larger than `inner`. */
  outer: number
  /**
   * Pull at full contraction, -1..1. Skin moves towards the origin by this fraction of its distance from the origin. In a sheet, skin moves
   * along the fibres by this fraction of the muscle's length.
   */
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
