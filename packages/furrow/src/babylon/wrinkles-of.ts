import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Node } from '@babylonjs/core/node.js'
import { addedTo, type WrinklesBase } from './wrinkles-base.ts'

/** What Babylon.js returns of a file: an asset container, or what was imported of it; or a copy by `instantiateModelsToScene`. */
export type LoadedFile =
  | {
      /** All meshes of the file. */
      readonly meshes: readonly AbstractMesh[]
    }
  | {
      /** The roots of a copy. */
      readonly rootNodes: readonly Node[]
    }

/** The wrinkles of a mesh, however they were added, or undefined. */
export function wrinklesOf(mesh: AbstractMesh): WrinklesBase | undefined
/** The wrinkles of a file or a copy of it, one per face; none if it has none, or was loaded before `registerWrinkleMaps`. */
export function wrinklesOf(file: LoadedFile): readonly WrinklesBase[]
export function wrinklesOf(
  source: AbstractMesh | LoadedFile,
): WrinklesBase | undefined | readonly WrinklesBase[] {
  if ('meshes' in source) return facesOf(source.meshes)
  if ('rootNodes' in source) {
    return facesOf(source.rootNodes.flatMap((root) => [root as AbstractMesh, ...root.getChildMeshes()]))
  }
  return addedTo(source)
}

function facesOf(meshes: readonly AbstractMesh[]): WrinklesBase[] {
  return [...new Set(meshes.flatMap((mesh) => addedTo(mesh) ?? []))]
}
