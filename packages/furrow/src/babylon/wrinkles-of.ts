import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Node } from '@babylonjs/core/node.js'
import { isObject, wrongArgument } from '../core/argument.ts'
import type { FurrowError } from '../core/error.ts'
import { warnIfUnregistered } from './registered.ts'
import { addedTo } from './wrinkled-mesh.ts'
import { type WrinklesBase, wrinklesFor } from './wrinkles-base.ts'

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

/**
 * The wrinkles of a mesh, however they were added, or undefined.
 *
 * @throws FurrowError when it is neither a mesh nor a loaded file.
 */
export function wrinklesOf(mesh: AbstractMesh): WrinklesBase | undefined
/**
 * The wrinkles of a file or a copy of it, one per face; none if it has none, or was loaded before `registerWrinkleMaps`. Warns once if that
 * was never called.
 *
 * @throws FurrowError when it is neither a mesh nor a loaded file.
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
  const own = addedTo(source)
  return own && wrinklesFor(own)
}

function wrongSource(value: unknown): FurrowError {
  const limit = 'what Babylon.js returned of a file, or a Mesh or InstancedMesh'
  return wrongArgument('wrinklesOf', 'invalid argument', value, limit)
}

function facesOf(meshes: readonly AbstractMesh[]): WrinklesBase[] {
  const own = new Set(meshes.flatMap((mesh) => addedTo(mesh) ?? []))
  const faces = [...own].map(wrinklesFor)
  if (faces.length === 0) warnIfUnregistered()
  return faces
}
