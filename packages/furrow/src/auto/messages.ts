import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import type { ErrorParts } from '../core/error.ts'
import type { CharacterData } from './character.ts'
import type { CharacterWrinkles } from './make-wrinkles.ts'

/**
 * A job that a page sends to the worker. `skin` makes wrinkles for a skin. `character` chooses the skin among several meshes and makes
 * wrinkles for it. `shapes` recognises the blendshapes of a skin.
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
   * Name of a Web Lock that the worker holds until it ends. The page requests the lock too, to notice that the worker has ended. Undefined if
   * the browser has no Web Locks.
   */
  lock?: string | undefined
}

/** A message from the worker. The order is `started`, any number of `progress`, `made`, `finished`. After an error, `failed` is the last. */
export type AutoReply =
  | { type: 'started'; lock?: string | undefined }
  | { type: 'progress'; done: number; total: number; step: string }
  | { type: 'made'; result: AutoResults[keyof AutoResults] }
  /** Sent when the worker has nothing left to do. For the job `character`, this is after the attempt to cache the result. */
  | { type: 'finished' }
  /** `parts` are the fields of a FurrowError. The page creates the error again, because a message does not keep the class of an error. */
  | { type: 'failed'; parts?: ErrorParts; message: string }
