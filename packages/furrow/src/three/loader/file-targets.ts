import type { Mesh } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { soleExpressions } from '../../drivers/morph/vrm-binds.ts'
import { hoistTargetNames } from '../../runtime/file/hoist-target-names.ts'

type ParsedFile = Pick<GLTFParser, 'json' | 'associations'>

/** Sets blendshape names that three.js does not read; see `hoistTargetNames`. */
export function nameTargets({ json, associations }: ParsedFile, meshes: readonly Mesh[]): void {
  const named = structuredClone({ meshes: json.meshes })
  hoistTargetNames(named)
  for (const mesh of meshes) {
    const { targetNames } = named.meshes?.[associations.get(mesh)?.meshes ?? -1]?.extras ?? {}
    if (!Array.isArray(targetNames) || targetNames.length !== mesh.morphTargetInfluences?.length) continue
    mesh.morphTargetDictionary = Object.fromEntries(targetNames.map((name, i) => [name, i]))
  }
}

/** Names of VRM expressions that move exactly one blendshape of a mesh, by target index. */
export function expressionsOfMesh({ json, associations }: ParsedFile, mesh: Mesh): Map<number, string> {
  return soleExpressions(json, associations.get(mesh)?.meshes ?? -1)
}
