import type { Curve } from '../curve.ts'
import type { DriverDefinition } from '../definition.ts'
import { linkTo } from '../link.ts'
import { curveText } from '../text.ts'

/** Activates an area by a joint: how far it has turned, or how far it is from another. */
export interface BoneDriver {
  type: 'bone'
  area: string
  /** Names of two nodes: what the joint is measured from, and the joint. */
  joints: [from: string, joint: string]
  /** `angle`: radians by which the joint is turned from its rest pose, as seen from the other. `distance`: metres between the two. */
  measure: 'angle' | 'distance'
  /** Of an angle: the axis it is counted about, in the frame of the joint at rest, signed; absent: about any axis. */
  axis?: [number, number, number]
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
  describe: ({ area, joints: [from, joint], measure, axis, curve }) =>
    measure === 'distance'
      ? `${area} = metres from joint ${from} to ${joint}${curveText(curve)}`
      : `${area} = turn of joint ${joint} seen from ${from}${axis ? ` about ${axis.join(' ')}` : ''}${curveText(curve)}`,
  activate: ({ area, joints: [from, joint], measure, axis, curve }) => ({
    area,
    links: linkTo({ kind: 'joint', from, joint, measure, ...(axis && { axis }) }),
    rule: 'sum',
    curve,
  }),
}
