import type { Mesh } from 'three'
import { isObject, wrongArgument } from '../core/argument.ts'
import { sentence } from '../core/error.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { addedTo } from './added-to.ts'
import { adoptedBy } from './loader/adoption.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/** What `GLTFLoader` returns, three.js's or another's, as far as `wrinklesOf` reads it. */
export interface LoadedFile {
  scene: object
  // biome-ignore lint/suspicious/noExplicitAny: as three.js declares it
  userData: Record<string, any>
  // biome-ignore lint/suspicious/noExplicitAny: each package has a parser type of its own
  parser?: any
}

/**
 * The wrinkles of a mesh, however they were added, or undefined; if there are several, the first.
 *
 * @throws FurrowError when it is neither a mesh nor a loaded file.
 */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined
/**
 * The wrinkles of a file, one per face; none if the file has none. Warns once if it has, but was loaded without `WrinkleLoaderPlugin`.
 *
 * @throws FurrowError when it is neither a mesh nor a loaded file.
 */
export function wrinklesOf(file: LoadedFile): readonly WrinklesBase[]
export function wrinklesOf(source: Mesh | LoadedFile): WrinklesBase | undefined | readonly WrinklesBase[] {
  if ((source as Mesh)?.isMesh) return (addedTo(source as Mesh) as WrinklesBase) ?? adoptedBy(source as Mesh)
  if (!isLoadedFile(source)) {
    const value = isObject(source) ? source.constructor?.name : source
    const limit = 'what GLTFLoader returned, such as gltf instead of gltf.scene, or a Mesh'
    throw wrongArgument('wrinklesOf', 'a loaded file or a mesh', value, limit)
  }
  const { wrinkles } = source.userData
  if (!wrinkles) warnUnregistered(source)
  return wrinkles ?? []
}

/**
 * Waits for the wrinkles that `WrinkleLoaderPlugin` makes for a file with its option `auto`.
 *
 * @returns a promise of the wrinkles of the file, one per face: none if none can be made, or that was cancelled. Other files need no waiting.
 * @throws FurrowError when it is not a loaded file.
 */
export async function wrinklesReady(file: LoadedFile): Promise<readonly WrinklesBase[]> {
  if (!isLoadedFile(file)) {
    const value = isObject(file) ? (file as object).constructor?.name : file
    throw wrongArgument('wrinklesReady', 'a loaded file', value, 'what GLTFLoader returned')
  }
  await file.userData.wrinklesReady
  return wrinklesOf(file)
}

function isLoadedFile(source: unknown): source is LoadedFile {
  return isObject(source) && 'scene' in source && isObject((source as LoadedFile).userData)
}

const warned = new WeakSet<object>()

/** Files with wrinkles that nobody has read. */
function warnUnregistered({ parser }: LoadedFile): void {
  const json = parser?.json
  if (!isObject(json) || warned.has(json)) return
  const { extensionsUsed } = json as { extensionsUsed?: unknown }
  if (!Array.isArray(extensionsUsed) || !extensionsUsed.includes(WRINKLE_MAPS)) return
  warned.add(json)
  console.warn(
    sentence({
      who: 'wrinklesOf',
      problem: `the file has ${WRINKLE_MAPS}, but was loaded without WrinkleLoaderPlugin: its faces stay plain`,
      remedy: 'call extendLoader(loader) before loading it',
    }),
  )
}
