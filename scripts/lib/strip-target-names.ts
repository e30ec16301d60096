import type { Document } from '@gltf-transform/core'
import { canonicalTargetName } from 'furrow/internal'
import { removeNames } from '../../test/heads.ts'

/**
 * Removes the names of all blendshapes.
 *
 * @returns what stands in place of each name, by ARKit's names.
 */
export function nameless(document: Document): Map<string, string> {
  const names = targetNames(document).map(canonicalTargetName)
  removeNames(document)
  const left = targetNames(document)
  return new Map(names.map((name, i) => [name, left[i]!]))
}

/** Names of the blendshapes of all meshes, each once. */
function targetNames(document: Document): string[] {
  const meshes = document.getRoot().listMeshes()
  return [...new Set(meshes.flatMap((mesh) => (mesh.getExtras().targetNames as string[]) ?? []))]
}
