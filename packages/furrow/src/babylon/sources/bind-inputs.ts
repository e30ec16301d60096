import type { Scene } from '@babylonjs/core/scene.js'
import type { DriverPlan } from '../../drivers/plan.ts'
import type { InputReaders } from '../../runtime/driver-runtime.ts'
import { bindJoints } from './joint.ts'
import { bindTargets } from './target.ts'
import { bindTension, type DrivenFace } from './tension.ts'

/** Creates readers that read the inputs of drivers from the mesh of a face. */
export function bindInputs(
  face: DrivenFace,
  { target, joint, tension }: DriverPlan['inputs'],
): InputReaders<Scene> {
  return {
    target: bindTargets(face.mesh, target),
    joint: bindJoints(face.mesh, joint),
    // Tension is bound only if a driver needs it, because binding reads all vertices of the mesh.
    ...(tension.length > 0 && { tension: bindTension(face, tension) }),
  }
}
