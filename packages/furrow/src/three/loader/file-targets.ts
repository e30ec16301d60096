import type { Mesh } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { soleExpressions } from '../../drivers/morph/vrm-binds.ts'
import { hoistTargetNames } from '../../runtime/file/hoist-target-names.ts'

type ParsedFile = Pick<GLTFParser, 'json' | 'associations'>

/** Sets the names of blendshapes if the file stores these names where three.js does not read them; see `hoistTargetNames`. */
export function nameTargets({ json, associations }: ParsedFile, meshes: readonly Mesh[]): void {
  const named = structuredClone({ meshes: json.meshes })
  hoistTargetNames(named)
  for (const mesh of meshes) {
    const { targetNames } = named.meshes?.[associations.get(mesh)?.meshes ?? -1]?.extras ?? {}
    if (!Array.isArray(targetNames) || targetNames.length !== mesh.morphTargetInfluences?.length) continue
    mesh.morphTargetDictionary = Object.fromEntries(targetNames.map((name, i) => [name, i]))
  }
}

/** Returns the VRM expressions that move exactly one blendshape of a mesh: the name of the expression, by blendshape index. */
export function expressionsOfMesh({ json, associations }: ParsedFile, mesh: Mesh): Map<number, string> {
  return soleExpressions(json, associations.get(mesh)?.meshes ?? -1)
}
