import { FurrowError } from '../core/error.ts'

/** A morph target of one mesh and the name that matched it. */
export interface TargetBinding {
  /** Weights of the mesh's targets by index; written. */
  influences: { [target: number]: number }
  /** Index of the target. */
  target: number
  /** Index of the name in the list. */
  name: number
}

/** Finds morph targets by name on all meshes of a face. */
export type BindTargets = (names: readonly string[]) => TargetBinding[]

/** Creates the error for a face without morph targets; `face` is its name. */
export function noTargets(who: string, face: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'no morph targets',
    value: face,
    limit: 'at least one mesh with named blendshapes',
    remedy: 'export the blendshapes with the face, or set activations yourself',
  })
}
