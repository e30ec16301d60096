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
