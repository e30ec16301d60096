import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import type { ErrorParts } from '../core/error.ts'
import type { CharacterJob, MeshWrinkles } from './make-wrinkles.ts'

/**
 * A job that a page sends to the worker. `skin` makes wrinkles for a skin. `character` chooses the surfaces of a character and makes wrinkles
 * for them. `shapes` recognises the blendshapes of a skin.
 */
export type AutoJob =
  | { type: 'skin'; skin: Skin }
  | { type: 'character'; character: CharacterJob }
  | { type: 'shapes'; skin: Skin }

/** Result of each type of job. */
export interface AutoResults {
  skin: AutoWrinkles
  /** Notes about meshes without wrinkles. The wrinkles are in the parts before. */
  character: string[]
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

/**
 * A message from the worker. The order is `started`, any number of `progress` and `part`, `made`, `finished`. After an error, `failed` is the
 * last.
 */
export type AutoReply =
  | { type: 'started'; lock?: string | undefined }
  | { type: 'progress'; done: number; total: number; step: string }
  /** Wrinkles of one mesh of a character. */
  | { type: 'part'; part: MeshWrinkles }
  | { type: 'made'; result: AutoResults[keyof AutoResults] }
  /** Sent when the worker has nothing left to do. For the job `character`, this is after the attempt to cache the results. */
  | { type: 'finished' }
  /** `parts` are the fields of a FurrowError. The page creates the error again, because a message does not keep the class of an error. */
  | { type: 'failed'; parts?: ErrorParts; message: string }
