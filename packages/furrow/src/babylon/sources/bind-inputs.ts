import type { Scene } from '@babylonjs/core/scene.js'
import type { DriverPlan } from '../../drivers/plan.ts'
import type { InputReaders } from '../../runtime/driver-runtime.ts'
import { bindJoints } from './joint.ts'
import { bindTargets } from './target.ts'
import { bindTension, type DrivenFace } from './tension.ts'

/** Binds the inputs of drivers to a face's mesh. */
export function bindInputs(
  face: DrivenFace,
  { target, joint, tension }: DriverPlan['inputs'],
): InputReaders<Scene> {
  return {
    target: bindTargets(face.mesh, target),
    joint: bindJoints(face.mesh, joint),
    // Only if needed: binding tension reads the complete mesh.
    ...(tension.length > 0 && { tension: bindTension(face, tension) }),
  }
}
