import type { DriverPlan } from '../../drivers/plan.ts'
import type { InputReaders } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import { bindJoints } from './joint.ts'
import { bindTargets, type InputOptions } from './target.ts'
import type { BindTension, DrivenFace } from './tension.ts'

/** Creates the readers of driver inputs on the mesh of a face: blendshape weights, joints and skin tension. */
export function bindInputs(
  face: DrivenFace,
  { target, joint, tension }: DriverPlan['inputs'],
  bindTension: BindTension,
  options: InputOptions = {},
): InputReaders<AnyRenderer> {
  return {
    target: bindTargets(face.mesh, target, options),
    joint: bindJoints(face.mesh, joint),
    tension: bindTension(face, tension),
  }
}
