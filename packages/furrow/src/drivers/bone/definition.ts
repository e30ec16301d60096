import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by the rotation of a joint, or by its distance from another joint. */
export interface BoneDriver {
  type: 'bone'
  /** Name of the area. */
  area: string
  /** Names of two nodes: the reference and the joint. */
  joints: [from: string, joint: string]
  /** `angle`: rotation from the rest pose relative to the reference, radians. `distance`: distance between the two, metres. */
  measure: 'angle' | 'distance'
  /** Angle only: axis of the signed rotation, in the rest frame of the joint. Default: total rotation. */
  axis?: [number, number, number]
  /** Points [radians or metres, activation]. */
  curve: Curve
}

export const bone: DriverDefinition<BoneDriver> = {
  type: 'bone',
  read: (fields) => ({
    area: fields.area(),
    joints: fields.names('joints'),
    measure: fields.choice('measure', ['angle', 'distance']),
    ...fields.axis(),
    curve: fields.curve(),
  }),
  activate: ({ area, joints: [from, joint], measure, axis, curve }) => ({
    area,
    links: linkTo({ kind: 'joint', from, joint, measure, ...(axis && { axis }) }),
    rule: 'sum',
    curve,
  }),
}
