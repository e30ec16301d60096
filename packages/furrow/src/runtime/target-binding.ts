import { FurrowError } from '../core/error.ts'

/** One morph target of one mesh, and the name that it was found by. */
export interface TargetBinding {
  /** Weights of the mesh's targets by index, which are written to. */
  influences: { [target: number]: number }
  /** Index of the target among them. */
  target: number
  /** Index of the name in the list. */
  name: number
}

/** Finds the morph targets with some names on all meshes of a face. */
export type BindTargets = (names: readonly string[]) => TargetBinding[]

/**
 * The error for a face that cannot move.
 *
 * @param face its name.
 */
export function noTargets(who: string, face: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'no morph targets',
    value: face,
    limit: 'at least one mesh with named blendshapes',
    remedy: 'export the blendshapes with the face, or set activations yourself',
  })
}
