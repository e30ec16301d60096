import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { MorphTargetManager } from '@babylonjs/core/Morph/morphTargetManager.js'
import type { Node } from '@babylonjs/core/node.js'
import { wrongArgument } from '../../core/argument.ts'
import { targetFinder } from '../../drivers/morph/target-names.ts'
import { noTargets, type TargetBinding } from '../../runtime/target-binding.ts'
import { targetNames } from './morph.ts'

/**
 * Finds morph targets by name on all meshes under a node. Names may have any spelling that `findTargets` knows.
 *
 * @param face root node of the meshes.
 * @throws FurrowError if no mesh has morph targets, or if `face` is not a node of Babylon.js.
 */
export function bindFaceTargets(face: Node, names: readonly string[], who: string): TargetBinding[] {
  if (typeof face?.getChildMeshes !== 'function') {
    throw wrongArgument(who, 'face', face, 'a mesh or TransformNode of Babylon.js')
  }
  const meshes = [face as AbstractMesh, ...face.getChildMeshes()]
  // A set removes duplicates, because instances and clones share the morph target manager of their source.
  const managers = new Set(meshes.flatMap(({ morphTargetManager }) => morphTargetManager ?? []))
  if (managers.size === 0) throw noTargets(who, face.name)
  return [...managers].flatMap((targets) => {
    const find = targetFinder(targetNames(targets))
    const influences = influencesOf(targets)
    return names.flatMap((wanted, name) => find(wanted).map((target) => ({ influences, target, name })))
  })
}

/** Creates an array-like object that reads and sets the weights of morph targets by index. */
function influencesOf(targets: MorphTargetManager): TargetBinding['influences'] {
  const influences = {}
  for (let i = 0; i < targets.numTargets; i++) {
    const target = targets.getTarget(i)
    Object.defineProperty(influences, i, {
      get: () => target.influence,
      set: (value: number) => {
        target.influence = value
      },
    })
  }
  return influences
}
