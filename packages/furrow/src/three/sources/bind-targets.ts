import type { Mesh, Object3D } from 'three'
import { FurrowError } from '../../core/error.ts'
import { targetFinder } from '../../drivers/target-names.ts'

/** One morph target of one mesh, and which of the names moves it. */
export interface TargetBinding {
  influences: number[]
  target: number
  /** Index into the names. */
  weight: number
}

/**
 * Finds the targets of some names on every mesh under an object, in any spelling that `findTargets` knows.
 *
 * @throws FurrowError when no mesh has morph targets at all.
 */
export function bindTargets(face: Object3D, names: readonly string[], who: string): TargetBinding[] {
  const bindings: TargetBinding[] = []
  let meshes = 0
  face.traverse((object) => {
    const { morphTargetDictionary, morphTargetInfluences } = object as Mesh
    if (!morphTargetDictionary || !morphTargetInfluences) return
    meshes++
    const targets = Object.keys(morphTargetDictionary)
    const find = targetFinder(targets)
    for (const [weight, name] of names.entries()) {
      for (const found of find(name)) {
        const target = morphTargetDictionary[targets[found]]
        bindings.push({ influences: morphTargetInfluences, target, weight })
      }
    }
  })
  if (meshes > 0) return bindings
  throw new FurrowError({
    who,
    what: 'no morph targets',
    value: face.name,
    limit: 'at least one mesh with named blendshapes',
    remedy: 'export the blendshapes with the face, or set activations yourself',
  })
}
