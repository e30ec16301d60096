import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'

/** Activates an area by a joint: by how far it is rotated, or how far it is from another. */
export interface BoneDriver {
  type: 'bone'
  /** Name of the area. */
  area: string
  /** Names of two nodes: the one that the joint is measured from, and the joint. */
  joints: [from: string, joint: string]
  /** `angle`: radians by which the joint is rotated from its rest pose, relative to the other. `distance`: metres between the two. */
  measure: 'angle' | 'distance'
  /** Of an angle: measure the signed rotation about this axis only, in the frame of the joint at rest; about any axis by default. */
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
