/** One morph target of one mesh, and which of a list of names sets it. */
export interface TargetBinding {
  /** Weights of the mesh's targets, written in place. */
  influences: number[]
  target: number
  /** Index into the names. */
  name: number
}

/** Finds the targets of some names on every mesh of a face. */
export type BindTargets = (names: readonly string[]) => TargetBinding[]
