import { FurrowError } from '../core/error.ts'

/** A morph target of one mesh, found by a name. */
export interface TargetBinding {
  /** Weights of all targets of the mesh, by index. Callers write the weight at index `target`. */
  influences: { [target: number]: number }
  target: number
  /** Index of the name in the argument of `BindTargets`. */
  name: number
}

/** Finds morph targets by name on all meshes of a face. */
export type BindTargets = (names: readonly string[]) => TargetBinding[]

export function noTargets(who: string, face: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'no morph targets',
    value: face,
    limit: 'at least one mesh with named blendshapes',
    remedy: 'export the blendshapes with the face, or set activations yourself',
  })
}
