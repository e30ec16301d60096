import type { Mesh } from 'three'
import { adoptedBy } from './loader/adoption.ts'
import { addedTo, type WrinklesBase } from './wrinkles-base.ts'

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
  return addedTo(source) ?? adoptedBy(source)
}
