import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import type { ErrorParts } from '../core/error.ts'
import type { CharacterData } from './character.ts'
import type { CharacterWrinkles } from './make-wrinkles.ts'

/** Request of a page: wrinkles for a skin, wrinkles for the skin of a character, or the recognised shapes of a skin. */
export type AutoJob =
  | { type: 'skin'; skin: Skin }
  | { type: 'character'; character: CharacterData }
  | { type: 'shapes'; skin: Skin }

/** Results of the worker, by type of job. */
export interface AutoResults {
  skin: AutoWrinkles
  character: CharacterWrinkles
  shapes: RecognisedShape[]
}

export type AutoRequest = AutoJob & {
  options: AutoOptions
  /** Version of the code that makes wrinkles. */
  version: string
  /** Name of a lock that the worker holds while it lives, if the page supports locks. */
  lock?: string | undefined
}

/** Replies of the worker: `started`, any number of `progress`, then `made` and `finished`, or `failed`. */
export type AutoReply =
  | { type: 'started'; lock?: string | undefined }
  | { type: 'progress'; done: number; total: number; step: string }
  | { type: 'made'; result: AutoResults[keyof AutoResults] }
  /** Sent after the result is cached, if requested and possible. */
  | { type: 'finished' }
  /** `parts` of a FurrowError, whose class and fields are lost between threads; `message` of other errors. */
  | { type: 'failed'; parts?: ErrorParts; message: string }
