import type { Mesh } from 'three'
import { addedTo } from './added-to.ts'
import { adoptedBy } from './loader/adoption.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/** What `GLTFLoader` returns, three.js's or another's, as far as `wrinklesOf` reads it. */
export interface LoadedFile {
  scene: object
  // biome-ignore lint/suspicious/noExplicitAny: as three.js declares it
  userData: Record<string, any>
}

/** The wrinkles of a mesh, however they were added, or undefined; if there are several, the first. */
export function wrinklesOf(mesh: Mesh): WrinklesBase | undefined
/** The wrinkles of a file, one per face; none if it has none, or `WrinkleLoaderPlugin` did not load it. */
export function wrinklesOf(file: LoadedFile): readonly WrinklesBase[]
export function wrinklesOf(source: Mesh | LoadedFile): WrinklesBase | undefined | readonly WrinklesBase[] {
  if ('scene' in source) return source.userData?.wrinkles ?? []
  return (addedTo(source) as WrinklesBase | undefined) ?? adoptedBy(source)
}

/**
 * Waits for the wrinkles that `WrinkleLoaderPlugin` makes for a file with its option `auto`.
 *
 * @returns a promise of the wrinkles of the file, one per face, which never rejects: none if none can be made, or that was cancelled. Other
 *   files need no waiting.
 */
export async function wrinklesReady(file: LoadedFile): Promise<readonly WrinklesBase[]> {
  await file.userData?.wrinklesReady
  return wrinklesOf(file)
}
