import type { Mesh, Object3D } from 'three'
import { wrongArgument } from '../../core/argument.ts'
import { targetFinder } from '../../drivers/morph/target-names.ts'
import { noTargets, type TargetBinding } from '../../runtime/target-binding.ts'

/**
 * Finds morph targets by name on all meshes under an object. Accepts other spellings of a name, see `findTargets`.
 *
 * @throws FurrowError if no mesh has morph targets, or `face` is not an Object3D.
 */
export function bindTargets(face: Object3D, names: readonly string[], who: string): TargetBinding[] {
  if (typeof face?.traverse !== 'function') throw wrongArgument(who, 'face', face, 'an Object3D of three.js')
  const bindings: TargetBinding[] = []
  let meshes = 0
  face.traverse((object) => {
    const { morphTargetDictionary, morphTargetInfluences } = object as Mesh
    if (!morphTargetDictionary || !morphTargetInfluences) return
    meshes++
    const targets = Object.keys(morphTargetDictionary)
    const find = targetFinder(targets)
    for (const [index, name] of names.entries()) {
      for (const found of find(name)) {
        const target = morphTargetDictionary[targets[found]]
        bindings.push({ influences: morphTargetInfluences, target, name: index })
      }
    }
  })
  if (meshes > 0) return bindings
  throw noTargets(who, face.name)
}
