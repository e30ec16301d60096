import type { AutoProgress } from '../author/auto/auto.ts'
import { type AutoOptions, checkAutoOptions } from '../author/auto/options.ts'
import { isObject, wrongArgument } from '../core/argument.ts'

/** Options of `autoWrinkles`, and of the web worker that runs it. */
export interface AutoRunOptions extends AutoOptions {
  /** Is called before each step of the work, and at the end. */
  progress?: AutoProgress
  /** Signal that ends the worker when it is aborted. */
  signal?: AbortSignal
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
