import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Node } from '@babylonjs/core/node.js'
import { isObject, wrongArgument } from '../core/argument.ts'
import type { FurrowError } from '../core/error.ts'
import { warnIfUnregistered } from './registered.ts'
import { wrinklesOfMesh } from './wrinkled-mesh.ts'
import { type WrinklesBase, wrinklesFor } from './wrinkles-base.ts'

/** A loaded file: an asset container, an import result, or the result of `instantiateModelsToScene`. */
export type LoadedFile =
  | {
      readonly meshes: readonly AbstractMesh[]
    }
  | {
      /** Root nodes of a copy that `instantiateModelsToScene` made. */
      readonly rootNodes: readonly Node[]
    }

/**
 * Returns the wrinkles of a mesh, or undefined if it has none.
 *
 * @throws FurrowError if the argument is neither a mesh nor a loaded file.
 */
export function wrinklesOf(mesh: AbstractMesh): WrinklesBase | undefined
/**
 * Returns the wrinkles of a loaded file or of a copy, one object per face. The list is empty if the file has no wrinkles, or if it was
 * loaded before `registerWrinkleMaps` was called. Logs a warning if `registerWrinkleMaps` was never called.
 *
 * @throws FurrowError if the argument is neither a mesh nor a loaded file.
 */
export function wrinklesOf(file: LoadedFile): readonly WrinklesBase[]
export function wrinklesOf(
  source: AbstractMesh | LoadedFile,
): WrinklesBase | undefined | readonly WrinklesBase[] {
  if (!isObject(source)) throw wrongSource(source)
  if ('meshes' in source) return facesOf(source.meshes)
  if ('rootNodes' in source) {
    return facesOf(source.rootNodes.flatMap((root) => [root as AbstractMesh, ...root.getChildMeshes()]))
  }
  if (typeof source.isVerticesDataPresent !== 'function')
    throw wrongSource((source as object).constructor?.name)
  const face = wrinklesOfMesh(source)
  return face && wrinklesFor(face)
}

function wrongSource(value: unknown): FurrowError {
  const limit = 'a Mesh, an InstancedMesh, or a file loaded by Babylon.js'
  return wrongArgument('wrinklesOf', 'argument', value, limit)
}

function facesOf(meshes: readonly AbstractMesh[]): WrinklesBase[] {
  const faces = [...new Set(meshes.flatMap((mesh) => wrinklesOfMesh(mesh) ?? []))].map(wrinklesFor)
  if (faces.length === 0) warnIfUnregistered()
  return faces
}
