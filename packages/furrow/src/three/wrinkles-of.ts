import type { Mesh } from 'three'
import { isObject, wrongArgument } from '../core/argument.ts'
import { formatProblem } from '../core/error.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { adoptedBy } from './loader/adoption.ts'
import { wrinklesOfMesh } from './mesh-wrinkles.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/** Result of `GLTFLoader`, from three.js or another package. */
export interface LoadedFile {
  scene: object
  // biome-ignore lint/suspicious/noExplicitAny: three.js's own declaration
  userData: Record<string, any>
  // biome-ignore lint/suspicious/noExplicitAny: each package has its own parser type
  parser?: any
}

/**
 * Returns the wrinkles of a mesh, or undefined. If the mesh has several `Wrinkles`, returns the oldest that is still in use.
 *
 * @throws FurrowError if the argument is neither a mesh nor a loaded file.
 */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined
/**
 * Returns the wrinkles of a loaded file, one per face; an empty array if the file has none. Warns once if the file has wrinkles but was
 * loaded without `WrinkleLoaderPlugin`.
 *
 * @throws FurrowError if the argument is neither a mesh nor a loaded file.
 */
export function wrinklesOf(file: LoadedFile): readonly WrinklesBase[]
export function wrinklesOf(source: Mesh | LoadedFile): WrinklesBase | undefined | readonly WrinklesBase[] {
  if ((source as Mesh)?.isMesh)
    return (wrinklesOfMesh(source as Mesh) as WrinklesBase) ?? adoptedBy(source as Mesh)
  if (!isLoadedFile(source)) {
    const value = isObject(source) ? source.constructor?.name : source
    const limit = 'a Mesh, or the result of GLTFLoader (gltf, not gltf.scene)'
    throw wrongArgument('wrinklesOf', 'argument', value, limit)
  }
  const { wrinkles } = source.userData
  if (!wrinkles) warnUnregistered(source)
  return wrinkles ?? []
}

/**
 * Waits for the wrinkles that `WrinkleLoaderPlugin` generates with its option `auto`. Resolves at once for other files.
 *
 * @returns the wrinkles of the file, one per face; empty if no wrinkles can be generated, or if generation was aborted.
 * @throws FurrowError if the argument is not a loaded file.
 */
export async function wrinklesReady(file: LoadedFile): Promise<readonly WrinklesBase[]> {
  if (!isLoadedFile(file)) {
    const value = isObject(file) ? (file as object).constructor?.name : file
    throw wrongArgument('wrinklesReady', 'argument', value, 'the result of GLTFLoader')
  }
  await file.userData.wrinklesReady
  return wrinklesOf(file)
}

function isLoadedFile(source: unknown): source is LoadedFile {
  return isObject(source) && 'scene' in source && isObject((source as LoadedFile).userData)
}

const warned = new WeakSet<object>()

function warnUnregistered({ parser }: LoadedFile): void {
  const json = parser?.json
  if (!isObject(json) || warned.has(json)) return
  const { extensionsUsed } = json as { extensionsUsed?: unknown }
  if (!Array.isArray(extensionsUsed) || !extensionsUsed.includes(WRINKLE_MAPS)) return
  warned.add(json)
  console.warn(
    formatProblem({
      who: 'wrinklesOf',
      problem: `the file has ${WRINKLE_MAPS}, but was loaded without WrinkleLoaderPlugin: its faces have no wrinkles`,
      remedy: 'call extendLoader(loader) before loading the file',
    }),
  )
}
