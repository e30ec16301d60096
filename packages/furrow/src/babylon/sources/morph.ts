import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { MorphTargetManager } from '@babylonjs/core/Morph/morphTargetManager.js'

export function readWeights({ morphTargetManager: targets }: AbstractMesh, values: Float64Array): void {
  if (!targets) return
  const count = Math.min(values.length, targets.numTargets)
  for (let i = 0; i < count; i++) values[i] = targets.getTarget(i).influence
}

/** Returns the names of all morph targets, in the order of their indices. */
export function targetNames(targets: AbstractMesh['morphTargetManager']): string[] {
  return Array.from({ length: targets?.numTargets ?? 0 }, (_, i) => nameOf(targets!, i))
}

function nameOf(targets: MorphTargetManager, i: number): string {
  return targets.getTarget(i).name
}
