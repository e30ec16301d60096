/** Joint of a skeleton. */
export interface SkinJoint {
  name: string
  /** Index of the nearest ancestor in the list of joints; -1 if there is none. */
  parent: number
  /** Column-major 4 x 4 matrix from the joint to the space of the skin's positions, in the bind pose. */
  bind: ArrayLike<number>
  /** Name of the bone in a VRM humanoid, such as `leftIndexProximal`, if the file states it. */
  humanBone?: string | undefined
  /** Rotations from the rest pose that clips or poses show: packed quaternions (x, y, z, w) in the rest frame of the joint. */
  rotations?: ArrayLike<number> | undefined
}

/** Skeleton that moves a skin. */
export interface SkinSkeleton {
  joints: readonly SkinJoint[]
  /** Number of joints per vertex. */
  influences: number
  /** Index of a joint for each influence of each vertex. */
  indices: ArrayLike<number>
  /** Weight of each influence of each vertex, 0..1. */
  weights: ArrayLike<number>
}
