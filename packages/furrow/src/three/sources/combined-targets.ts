import type { Mesh } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { expressionBinds, writtenNames } from '../../drivers/morph/vrm-binds.ts'
import { type ReadWeights, targetNames, weightReader } from './morph.ts'
import type { MeshTargets } from './target.ts'

/**
 * Creates readers of a VRM face's original blendshape weights. Drivers refer to the blendshapes in the file, but the page may call three-vrm's
 * `VRMUtils.combineMorphs` at any time. `combineMorphs` replaces the blendshapes of a mesh by one blendshape per expression, named like the
 * expression. The readers then compute the original weights from the binds of the expressions in the file.
 *
 * @param json JSON of the file.
 * @param index index of the face's mesh in the file.
 */
export function combinableTargets(json: GLTFParser['json'], index: number): (mesh: Mesh) => MeshTargets {
  const written = writtenNames(json.meshes[index])
  const binds = expressionBinds(json, index)
  /** Returns how the weights of a mesh's current blendshapes contribute to the weights of the blendshapes in `names`. */
  const linksOf = (current: readonly string[], names: readonly string[]): Link[] => {
    const isUnchanged = current.length === written.length && current.every((name, i) => name === written[i])
    const isCombined = !isUnchanged && current.every((name) => binds.has(name))
    return current.flatMap((name, from) => {
      const to = names.indexOf(name)
      const moved = (isCombined && binds.get(name)) || []
      const links = moved.map(({ index, weight }) => ({ from, to: names.indexOf(written[index]), weight }))
      // If a combined expression has the name of an original blendshape, the name means the expression.
      if (!isCombined || !written.includes(name)) links.push({ from, to, weight: 1 })
      return links.filter(({ to }) => to >= 0)
    })
  }
  return (mesh) => {
    const names = [...new Set([...written, ...targetNames(mesh)])]
    let dictionary: Mesh['morphTargetDictionary']
    let links: Link[]
    let weights: Float64Array
    let readCurrent: ReadWeights
    const bind = () => {
      const current = targetNames(mesh)
      dictionary = mesh.morphTargetDictionary
      links = linksOf(current, names)
      weights = new Float64Array(current.length)
      readCurrent = weightReader(mesh, current)
    }
    bind()
    const read: ReadWeights = (values, instance) => {
      if (mesh.morphTargetDictionary !== dictionary) bind()
      readCurrent(weights, instance)
      values.fill(0, 0, names.length)
      for (let i = 0; i < links.length; i++) {
        const { from, to, weight } = links[i]
        values[to] += weight * weights[from]
      }
    }
    return { names, read }
  }
}

/** Contribution of a current blendshape (index `from`) to a weight that is read (index `to`). */
interface Link {
  from: number
  to: number
  weight: number
}
