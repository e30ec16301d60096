import type { Pixels } from '../images/pixels.ts'
import type { SetToPack } from '../pack/set-to-pack.ts'

/** Program or kind of files that an import reads. */
export const IMPORT_SOURCES = ['character-creator', 'metahuman', 'expressions'] as const
export type ImportSource = (typeof IMPORT_SOURCES)[number]

/** Wrinkles of another program in Furrow's format. */
export interface ImportedSet {
  set: SetToPack
  /** Normal map that the material needs, because it has none and the wrinkles change this one. */
  normalMap?: Pixels
  /** Sentences about what the source has and the result lacks, or what was replaced by the nearest that exists. */
  lost: string[]
  /** Fields and files that the import does not read. */
  unread: string[]
}

/** Settings of an import. */
export interface ImportSettings {
  /** Width and height of the maps in texels. Areas do not depend on it. */
  size: number
  /** Direction of green in the normal maps of the source. */
  green: 'up' | 'down'
  /** Exponents of Character Creator's regions by name, or for `all`. */
  powers: Readonly<Record<string, number>>
}
