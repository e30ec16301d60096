import type { Document } from '@gltf-transform/core'
import { canonicalTargetName } from 'furrow/internal'
import { removeNames } from '../../test/heads.ts'

/**
 * Replaces the names of all blendshapes with meaningless names.
 *
 * @returns the new names, by ARKit name.
 */
export function stripTargetNames(document: Document): Map<string, string> {
  const names = targetNames(document).map(canonicalTargetName)
  removeNames(document)
  const replacements = targetNames(document)
  return new Map(names.map((name, i) => [name, replacements[i]!]))
}

function targetNames(document: Document): string[] {
  const meshes = document.getRoot().listMeshes()
  return [...new Set(meshes.flatMap((mesh) => (mesh.getExtras().targetNames as string[]) ?? []))]
}
