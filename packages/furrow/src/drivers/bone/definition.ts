import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Driver that activates an area (a group of wrinkles) by the rotation of a joint, or by the distance between two joints. */
export interface BoneDriver {
  type: 'bone'
  /** Name of the activated area. */
  area: string
  /** Names of two nodes: a reference node, and the joint that is measured relative to it. */
  joints: [from: string, joint: string]
  /** `angle`: rotation of the joint from its rest pose, in radians. `distance`: distance of the joint from the reference, in metres. */
  measure: 'angle' | 'distance'
  /** Axis of a signed angle, in the rest frame of the joint. Without an axis, the angle of the total rotation is measured. */
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
