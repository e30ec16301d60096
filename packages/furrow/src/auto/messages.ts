import type { AutoOptions, AutoWrinkles } from '../author/auto/auto.ts'
import type { Skin } from '../author/skin/surface.ts'
import type { ErrorParts } from '../core/error.ts'

/** What the page asks of the worker, once. */
export interface AutoRequest {
  skin: Skin
  options: AutoOptions
  /** Name of a lock that the worker holds while it lives, where the page has locks. */
  lock?: string | undefined
}

/** What the worker answers: `started`, any number of `progress`, and `made` or `failed`. */
export type AutoReply =
  | { type: 'started'; lock?: string | undefined }
  | { type: 'progress'; done: number; total: number; step: string }
  | { type: 'made'; wrinkles: AutoWrinkles }
  /** `parts` of a FurrowError, whose class and fields are lost between threads; `message` of any other. */
  | { type: 'failed'; parts?: ErrorParts; message: string }
