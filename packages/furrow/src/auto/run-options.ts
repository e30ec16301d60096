import type { AutoProgress } from '../author/auto/auto.ts'
import { SURFACE_KINDS, type SurfaceKind } from '../author/auto/character/surface-kinds.ts'
import type { ClothKind } from '../author/auto/cloth/cloth-kinds.ts'
import { type AutoOptions, checkAutoOptions } from '../author/auto/options.ts'
import { isObject, wrongArgument } from '../core/argument.ts'

/** Options of `autoWrinkles`, and of the web worker that runs it. */
export interface AutoRunOptions extends AutoOptions {
  /** Is called before each step of the work, and at the end. */
  progress?: AutoProgress
  /** Signal that ends the worker when it is aborted. */
  signal?: AbortSignal
}

/** Options of loaders for the automatic wrinkles of a character. */
export interface AutoCharacterOptions extends Omit<AutoRunOptions, 'cloth' | 'frame' | 'tubes'> {
  /** Kinds by name of a mesh or material, for characters whose names do not tell what is skin, cloth or hard. */
  kinds?: Readonly<Record<string, SurfaceKind>>
  /** How stiff all cloth is. Default: told by the names of materials and meshes. */
  cloth?: ClothKind
}

/**
 * Checks options before a worker is started.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError for the first option that is unknown or out of range.
 */
export function checkRunOptions(options: AutoRunOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object such as { age: 45 }')
  const { progress, signal, ...others } = options
  checkAutoOptions(others, who)
}

/**
 * Checks the options of a character before its file is loaded.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError for the first option that is unknown or out of range.
 */
export function checkCharacterOptions(options: AutoCharacterOptions, who: string): void {
  if (!isObject(options)) throw wrongArgument(who, 'options', options, 'an object such as { age: 45 }')
  const { progress, signal, ...others } = options
  checkAutoOptions(others, who, ['kinds'])
  const { kinds = {} } = options
  if (!isObject(kinds)) throw wrongArgument(who, 'kinds', kinds, "an object such as { Body: 'skin' }")
  const wrong = Object.values(kinds).find((kind) => !SURFACE_KINDS.includes(kind))
  if (wrong !== undefined) throw wrongArgument(who, 'kind', wrong, SURFACE_KINDS.join(', '))
}
