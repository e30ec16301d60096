import type { DriverPlan } from '../../drivers/plan.ts'
import type { InputReaders } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import { bindJoints } from './joint.ts'
import { bindTargets, type InputOptions } from './target.ts'
import type { BindTension, DrivenFace } from './tension.ts'

/** Binds the inputs of drivers to a face's mesh. */
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
