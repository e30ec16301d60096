import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import type { ErrorParts } from '../core/error.ts'
import type { CharacterData } from './character.ts'
import type { CharacterWrinkles } from './make-wrinkles.ts'

/**
 * Work that a page requests. `skin` makes wrinkles for a skin. `character` finds the skin among several meshes and makes its wrinkles.
 * `shapes` recognises the blendshapes of a skin.
 */
export type AutoJob =
  | { type: 'skin'; skin: Skin }
  | { type: 'character'; character: CharacterData }
  | { type: 'shapes'; skin: Skin }

/** Result of each type of job. */
export interface AutoResults {
  skin: AutoWrinkles
  character: CharacterWrinkles
  shapes: RecognisedShape[]
}

export type AutoRequest = AutoJob & {
  options: AutoOptions
  /** Version of the worker's code. */
  version: string
  /**
   * Name of a Web Lock that the worker holds until it ends, so that the page notices its end. Undefined if the browser has no Web Locks.
   */
  lock?: string | undefined
}

/** Messages of the worker, in this order: `started`, any number of `progress`, then `made` and `finished`. `failed` ends the sequence. */
export type AutoReply =
  | { type: 'started'; lock?: string | undefined }
  | { type: 'progress'; done: number; total: number; step: string }
  | { type: 'made'; result: AutoResults[keyof AutoResults] }
  /** Sent when the worker has nothing left to do. A result of the job `character` is then cached, if possible. */
  | { type: 'finished' }
  /** `parts` are the fields of a FurrowError, from which the page recreates it: messages between threads lose the class of an error. */
  | { type: 'failed'; parts?: ErrorParts; message: string }
